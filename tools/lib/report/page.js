for (const input of document.querySelectorAll('.slider input')) {
    const show = () => input.parentElement.style.setProperty('--at', input.value + '%');
    input.addEventListener('input', show);
    // A browser may bring back where it stood.
    show();
}

// Light or dark: what the reader's system says, until the button is used.
const page = document.documentElement;
const remembered = (action) => { try { return action(localStorage); } catch { return null; } };
const chosen = remembered((storage) => storage.getItem('theme'));
if (chosen) page.dataset.theme = chosen;
document.getElementById('theme').addEventListener('click', () => {
    const isDark = getComputedStyle(page).colorScheme === 'dark';
    page.dataset.theme = isDark ? 'light' : 'dark';
    remembered((storage) => storage.setItem('theme', page.dataset.theme));
});
