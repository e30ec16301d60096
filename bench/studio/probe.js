/* Script that the benchmark adds to the studio, before the studio's scripts. `window.probe` reports when pixels of the stage, the 3D view, change. */
{
  /** WebGL context of the stage, which is the last context that the studio requests. */
  let gl = null
  let draws = 0
  /** Watched rectangle, the hash of its pixels when watching began, and the times of the first frame with other pixels. */
  let watch = null

  const { getContext } = HTMLCanvasElement.prototype
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    if (kind !== 'webgl2') return getContext.call(this, kind, options)
    // `preserveDrawingBuffer` keeps the pixels readable after the frame.
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

  /** Hashes the stage's pixels in a rectangle, which is in CSS pixels relative to the stage. Waits for the GPU. */
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
    /** Times when the frames of the stage were submitted. Like all times here, they are milliseconds on the clock of `performance.now`. */
    frames: [],
    /** Timestamp of the last event, by event type. */
    events: {},
    /** Durations of main-thread tasks longer than 50 ms, milliseconds. */
    tasks: [],
    /** Times when the stage finished loading a face. */
    ready: [],
    /** Time when the panel first listed areas after the last drop of a file. */
    wrinkled: null,

    watch(rect) {
      watch = { rect, before: hashOf(rect), changed: null }
    },
    /** Returns the times when the first frame with changed pixels was submitted, and when its pixels could be read. Null if nothing has changed. */
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
    const panel = document.querySelector('#drawer')
    new MutationObserver(() => {
      const hasAreas = panel.querySelector('#areas .row') !== null
      if (!hasAreas) probe.wrinkled = null
      else if (probe.events.drop) probe.wrinkled ??= performance.now()
    }).observe(panel, { childList: true, subtree: true })
  })
}
