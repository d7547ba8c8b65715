// Looks at the report's page in the frame and says in the document what is wrong: "check: right, HEIGHT", or the faults.
const frame = document.getElementById('frame');
const faults = [];
const expect = (holds, fault) => { if (!holds) faults.push(fault); };

// The luminance as WCAG 2 has it, for the ratio of two colours'.
function luminance(colour) {
    const [r, g, b] = colour.match(/[\d.]+/g).map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}
function contrast(a, b) {
    const [dark, light] = [luminance(a), luminance(b)].sort((x, y) => x - y);
    return (light + 0.05) / (dark + 0.05);
}

function checkWidth(page) {
    const root = page.documentElement;
    expect(root.scrollWidth <= root.clientWidth, `it is ${root.scrollWidth} wide, the window ${root.clientWidth}`);
}

function checkLinks(page) {
    const links = [...page.querySelectorAll('a')];
    expect(links.length >= 10, `only ${links.length} links`);
    for (const link of links) {
        const target = link.getAttribute('href');
        expect(target.startsWith('#') && page.getElementById(target.slice(1)), `${target} leads nowhere`);
    }
}

function checkImages(page) {
    const images = [...page.querySelectorAll('img')];
    expect(images.length > 0, 'no pictures');
    for (const image of images) {
        expect(image.complete && image.naturalWidth > 0, `a picture is broken: ${image.alt}`);
        expect(image.alt !== '', 'a picture without words');
        const ratio = image.clientWidth / image.clientHeight * image.naturalHeight / image.naturalWidth;
        expect(Math.abs(ratio - 1) < 0.02, `a picture is out of shape: ${image.alt}`);
    }
    expect(page.querySelectorAll('.missing').length === 0, 'pictures are missing');
}

// A slider that is moved shows that much of the upper picture, and the keyboard reaches it.
function checkSliders(page, view) {
    const sliders = [...page.querySelectorAll('.slider')];
    expect(sliders.length === 4, `${sliders.length} sliders, not 4`);
    for (const slider of sliders) {
        const input = slider.querySelector('input');
        const over = slider.querySelector('.over');
        const lower = slider.querySelector('img:not(.over)');
        const shown = () => view.getComputedStyle(over).clipPath;
        const before = shown();
        input.focus();
        expect(page.activeElement === input, 'a slider cannot have the focus');
        input.value = 20;
        input.dispatchEvent(new view.Event('input', { bubbles: true }));
        expect(shown() !== before && shown().includes('80%'), `a slider at 20 shows ${shown()}`);
        expect(over.clientWidth === lower.clientWidth && over.clientHeight === lower.clientHeight,
            'the two pictures of a slider do not cover each other');
        input.value = 50;
        input.dispatchEvent(new view.Event('input', { bubbles: true }));
    }
    page.activeElement.blur();
}

function checkContrast(page, view) {
    const paper = (element) => {
        const colour = view.getComputedStyle(element).backgroundColor;
        return /, 0\)$/.test(colour) ? paper(element.parentElement) : colour;
    };
    for (const selector of ['p', '.facts', 'a', 'blockquote', 'summary', 'button', 'pre i', 'pre b', 'pre u', 'pre var']) {
        const element = page.querySelector(selector);
        const ratio = contrast(view.getComputedStyle(element).color, paper(element));
        expect(ratio >= 4.5, `${selector}: contrast ${ratio.toFixed(1)}, less than 4.5`);
    }
}

// The button turns light to dark or back, and keeps text legible.
function checkTheme(page, view) {
    const paper = () => view.getComputedStyle(page.body).backgroundColor;
    const before = paper();
    const isDark = luminance(before) < 0.2;
    expect(isDark === view.matchMedia('(prefers-color-scheme: dark)').matches, 'not in the system\'s colours');
    checkContrast(page, view);
    page.getElementById('theme').click();
    expect(luminance(paper()) < 0.2 !== isDark, 'the button does not turn light and dark');
    checkContrast(page, view);
    page.getElementById('theme').click();
    expect(paper() === before, 'the button does not turn back');
    view.localStorage.clear();
}

function check() {
    const page = frame.contentDocument;
    const view = frame.contentWindow;
    view.localStorage.clear();
    checkWidth(page);
    for (const details of page.querySelectorAll('details')) details.open = true;
    checkWidth(page);
    checkLinks(page);
    checkImages(page);
    checkSliders(page, view);
    checkTheme(page, view);
    for (const details of page.querySelectorAll('details')) details.open = false;
    return page.documentElement.scrollHeight;
}

frame.addEventListener('load', () => {
    let height = 0;
    try {
        height = check();
    } catch (error) {
        faults.push(String(error));
    }
    const said = document.createElement('p');
    said.textContent = `check: ${faults.length === 0 ? `right, ${height}` : faults.join('; ')}`;
    document.body.append(said);
});
