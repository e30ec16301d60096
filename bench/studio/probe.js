/* Runs before the studio's scripts. `window.probe` reports changes of the stage. */
{
  /** The stage's context: the last one requested. */
  let gl = null
  let draws = 0
  /** Rectangle to watch, its hash, and the times of its first change. */
  let watch = null

  const { getContext } = HTMLCanvasElement.prototype
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    if (kind !== 'webgl2') return getContext.call(this, kind, options)
    // Keeps pixels readable between frames.
    const context = getContext.call(this, kind, { ...options, preserveDrawingBuffer: true })
    if (context) gl = context
    return context
  }
  const { drawElements } = WebGL2RenderingContext.prototype
  WebGL2RenderingContext.prototype.drawElements = function (...args) {
    draws++
    return drawElements.apply(this, args)
  }

  const request = window.requestAnimationFrame.bind(window)
  window.requestAnimationFrame = (callback) =>
    request((now) => {
      const before = draws
      callback(now)
      if (draws > before) onFrame()
    })

  function onFrame() {
    const submitted = performance.now()
    probe.frames.push(submitted)
    if (!watch || watch.changed || hashOf(watch.rect) === watch.before) return
    watch.changed = { submitted, seen: performance.now() }
  }

  /** Hashes the pixels of a rectangle in CSS pixels of the stage. Waits for the GPU. */
  function hashOf({ x, y, width, height }) {
    const ratio = gl.drawingBufferWidth / gl.canvas.clientWidth
    const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)]
    const pixels = new Uint8Array(4 * w * h)
    const bottom = gl.drawingBufferHeight - Math.round((y + height) * ratio)
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null)
    gl.readPixels(Math.round(x * ratio), bottom, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels)
    return pixels.reduce((hash, value) => Math.imul(hash ^ value, 16777619), -2128831035)
  }

  const probe = {
    /** Time when each frame of the stage was submitted. */
    frames: [],
    /** Timestamp of the last event by type. All times are those of `performance.now`. */
    events: {},
    /** Durations of the main thread's tasks of more than 50 ms. */
    tasks: [],
    /** Times when the stage finished loading. */
    ready: [],
    /** Time when the panel first had areas after the last drop. */
    wrinkled: null,

    /** Starts watching a rectangle for changes. */
    watch(rect) {
      watch = { rect, before: hashOf(rect), changed: null }
    },
    /** Times when the first changed frame was submitted and drawn; null before. */
    changed: () => watch.changed,
    adapter() {
      const info = gl.getExtension('WEBGL_debug_renderer_info')
      return gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)
    },
  }
  window.probe = probe

  for (const type of ['drop', 'pointerdown', 'pointermove', 'keydown', 'input']) {
    const note = ({ timeStamp }) => {
      probe.events[type] = timeStamp
    }
    window.addEventListener(type, note, true)
  }
  new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) probe.tasks.push(duration)
  }).observe({ type: 'longtask' })
  document.addEventListener('DOMContentLoaded', () => {
    const stage = document.querySelector('#stage')
    new MutationObserver(() => {
      if (stage.getAttribute('aria-busy') === 'false') probe.ready.push(performance.now())
    }).observe(stage, { attributeFilter: ['aria-busy'] })
    const panel = document.querySelector('#panel')
    new MutationObserver(() => {
      const hasAreas = panel.querySelector('#areas .row') !== null
      if (!hasAreas) probe.wrinkled = null
      else if (probe.events.drop) probe.wrinkled ??= performance.now()
    }).observe(panel, { childList: true, subtree: true })
  })
}
