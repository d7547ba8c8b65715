#include "materials/material.h"

namespace materials {

std::vector<TextureUse> textureUses(const Material& material) {
    std::vector<TextureUse> uses;
    std::visit(
        [&]<class M>(const M& m) {
            for (const core::OptionRow<M>& row : M::options())
                std::visit(
                    [&]<class Value>(Value M::*member) {
                        if constexpr (core::isTextured<Value>)
                            if (const Value& value = m.*member; value.texture != nullptr)
                                uses.push_back({value.texture.get(), value.slot, row.range});
                    },
                    row.member);
        },
        material);
    return uses;
}

}  // namespace materials
