"""Two of grsh's materials that Mitsuba does not have: for its variants that compile what Python writes."""
import drjit as dr
import mitsuba as mi


class Metal(mi.BSDF):
    """Ashikhmin and Shirley's highlight with one exponent, from one side, of what reflects all light at any angle."""

    def __init__(self, properties):
        super().__init__(properties)
        self.exponent = properties["exponent"]
        self.colour = properties["colour"]
        flags = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide
        self.m_components = [flags]
        self.m_flags = flags

    def highlight(self, wi, wo):
        """The density of wo, and what is reflected that way over it."""
        half = dr.normalize(wi + wo)
        along = dr.dot(wi, half)
        common = dr.power(half.z, self.exponent) / along
        density = (self.exponent + 1) / (8 * dr.pi) * common
        return density, wo.z / dr.maximum(wi.z, wo.z)

    def above(self, wi, wo, active):
        return active & (wi.z > 0) & (wo.z > 0)

    def sample(self, context, si, chosen, place, active=True):
        cos = dr.power(place.x, 1 / (self.exponent + 1))
        sin = dr.safe_sqrt(1 - cos * cos)
        sin_phi, cos_phi = dr.sincos(2 * dr.pi * place.y)
        half = mi.Vector3f(sin * cos_phi, sin * sin_phi, cos)
        found = mi.BSDFSample3f()
        found.wo = 2 * dr.dot(si.wi, half) * half - si.wi
        density, weight = self.highlight(si.wi, found.wo)
        active = self.above(si.wi, found.wo, active)
        found.pdf = dr.select(active, density, 0)
        found.eta = 1
        found.sampled_type = mi.UInt32(+mi.BSDFFlags.GlossyReflection)
        found.sampled_component = 0
        return found, mi.Color3f(self.colour) * dr.select(active, weight, 0)

    def eval_pdf(self, context, si, wo, active=True):
        density, weight = self.highlight(si.wi, wo)
        density = dr.select(self.above(si.wi, wo, active), density, 0)
        return mi.Color3f(self.colour) * density * weight, density

    def eval(self, context, si, wo, active=True):
        return self.eval_pdf(context, si, wo, active)[0]

    def pdf(self, context, si, wo, active=True):
        return self.eval_pdf(context, si, wo, active)[1]

    def to_string(self):
        return "Metal[]"


class Glass(mi.BSDF):
    """Mitsuba's glass, and Beer's law: what arrives from inside has come through glass alone."""

    def __init__(self, properties):
        super().__init__(properties)
        self.clear = mi.load_dict({"type": "dielectric", "int_ior": properties["n"], "ext_ior": 1.0})
        self.beers = properties["beers"]
        self.m_components = [self.clear.flags(i) for i in range(self.clear.component_count())]
        self.m_flags = self.clear.flags()

    def sample(self, context, si, chosen, place, active=True):
        found, weight = self.clear.sample(context, si, chosen, place, active)
        left = dr.exp(-mi.Color3f(self.beers) * si.t)
        return found, weight * dr.select(si.wi.z < 0, left, 1)

    def eval(self, context, si, wo, active=True):
        return mi.Color3f(0)

    def pdf(self, context, si, wo, active=True):
        return mi.Float(0)

    def eval_pdf(self, context, si, wo, active=True):
        return mi.Color3f(0), mi.Float(0)

    def to_string(self):
        return "Glass[]"


mi.register_bsdf("grsh_metal", Metal)
mi.register_bsdf("grsh_glass", Glass)
