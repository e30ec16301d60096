// Functions that tests call in a page. `withHelper` in page-helper.ts inserts them before the page's own scripts.

const complaints = []
for (const level of ['error', 'warn']) {
  // biome-ignore lint/suspicious/noConsole: forwards the page's messages.
  const write = console[level]
  console[level] = (...parts) => {
    complaints.push(parts.map(String).join(' '))
    write.apply(console, parts)
  }
}
addEventListener(
  'error',
  ({ message, target }) => complaints.push(message ?? `cannot load ${target.src}`),
  true,
)
addEventListener('unhandledrejection', ({ reason }) => complaints.push(String(reason?.stack ?? reason)))

/** Files saved by the page, newest last. Pictures that the page shows are not among them. */
const savedFiles = []
const createObjectURL = URL.createObjectURL
URL.createObjectURL = (blob) => {
  if (!blob.type?.startsWith('image/')) savedFiles.push(blob)
  return createObjectURL.call(URL, blob)
}

/**
 * Draws the page's scene with and without wrinkles at the same animation time, and compares the red channels.
 * The region's edges are fractions of the picture.
 * @returns largest difference within the region, and contrast (maximum minus minimum) of the complete picture with wrinkles, both 0..255.
 */
async function compareWrinkles({ left, top, right, bottom }) {
  const imports = document.querySelector('script[type=importmap]').textContent
  const { all, draw } = await (imports.includes('furrow/babylon') ? babylonScene() : threeScene(imports))
  const drawn = []
  for (const mode of ['default', 'off']) {
    for (const wrinkles of all) wrinkles.mode = mode
    drawn.push(pixelsOf(await draw()))
  }
  const [wrinkled, smooth] = drawn
  for (const wrinkles of all) wrinkles.mode = 'default'
  const { width, height, data } = wrinkled
  let difference = 0
  let [low, high] = [255, 0]
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const i = 4 * (y * width + x)
      low = Math.min(low, data[i])
      high = Math.max(high, data[i])
      const isInside = x >= left * width && x < right * width && y >= top * height && y < bottom * height
      if (isInside) difference = Math.max(difference, Math.abs(data[i] - smooth.data[i]))
    }
  }
  return { difference, contrast: high - low }
}

/** Returns the wrinkles of a page's scene, and a function that draws the scene and returns its canvas. */
async function threeScene(imports) {
  const furrow = imports.includes('furrow/three') ? 'furrow/three' : 'furrow/webgpu'
  const [{ Scene }, { wrinklesOf }] = await Promise.all([import('three'), import(furrow)])
  const [renderer, scene, camera] = await new Promise((resolve) => {
    Scene.prototype.onBeforeRender = (...drawn) => resolve(drawn)
  })
  delete Scene.prototype.onBeforeRender
  // Lets the current frame end.
  await new Promise((resolve) => setTimeout(resolve))
  const all = new Set()
  scene.traverse((object) => object.isMesh && all.add(wrinklesOf(object)))
  all.delete(undefined)
  const draw = () => {
    renderer.render(scene, camera)
    return renderer.domElement
  }
  return { all, draw }
}

/** Does the same as `threeScene` for a page with Babylon.js. */
async function babylonScene() {
  const [{ EngineStore }, { wrinklesOf }] = await Promise.all([
    import('@babylonjs/core/Engines/engineStore.js'),
    import('furrow/babylon'),
  ])
  const { LastCreatedScene: scene, LastCreatedEngine: engine } = EngineStore
  const draw = async () => {
    // Wait, because Babylon.js compiles the shaders of a mode in the background and draws no mesh before its shader is ready.
    await scene.whenReadyAsync()
    scene.render()
    return engine.getRenderingCanvas()
  }
  return { all: wrinklesOf(scene), draw }
}

function pixelsOf(canvas) {
  const { width, height } = canvas
  const context = new OffscreenCanvas(width, height).getContext('2d')
  context.drawImage(canvas, 0, 0)
  return context.getImageData(0, 0, width, height)
}

/** Finds the first visible element that matches a selector. Optional: `name` is its label or text, `group` the label of its fieldset. */
function findElement(selector, name, group) {
  const labelOf = (fieldset) => document.getElementById(fieldset.getAttribute('aria-labelledby'))?.textContent
  const fieldsets = [...document.querySelectorAll('fieldset')]
  const root = group === undefined ? document : fieldsets.find((fieldset) => labelOf(fieldset) === group)
  return [...(root?.querySelectorAll(selector) ?? [])].find((element) => {
    if (!element.checkVisibility()) return false
    const names = [element.getAttribute('aria-label'), element.textContent, element.labels?.[0]?.textContent]
    return name === undefined || names.some((text) => text?.trim() === name)
  })
}

/** Scrolls to an element. Returns its rectangle in the window, or `null` if it is missing, still moving, or outside the window. */
async function reachElement(...names) {
  const element = findElement(...names)
  if (!element) return null
  element.scrollIntoView({ block: 'center' })
  const before = element.getBoundingClientRect()
  // Wait, because rows of a list can change their height when they become visible, and then move other rows.
  await new Promise((resolve) => setTimeout(resolve, 500))
  await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)))
  const { x, y, width, height } = element.getBoundingClientRect()
  const isInside = y + height / 2 > 0 && y + height / 2 < innerHeight
  return isInside && x === before.x && y === before.y ? { x, y, width, height } : null
}

/** Returns the last saved file as base64. */
async function readSaved() {
  const bytes = new Uint8Array(await savedFiles.at(-1).arrayBuffer())
  let text = ''
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192))
  return btoa(text)
}

window.furrowTest = { complaints, savedFiles, compareWrinkles, findElement, reachElement, readSaved }
