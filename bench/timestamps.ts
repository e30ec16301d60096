/// <reference types="@webgpu/types" />
/**
 * Times frames by the adapter's own clock: what it is busy with, and not what the processor needs to ask for it.
 * Each way runs `frames` and tells the milliseconds that all they drew has taken.
 */
export type Clock = (frames: () => void) => Promise<number>

/** Passes in frames that are timed together; a query set has two entries for each, 4096 at most. */
const MOST_PASSES = 2048

/**
 * Sums what every pass takes, those of mipmaps included, so that gaps between them in which the processor is not ready yet
 * do not count.
 *
 * @returns undefined where the device has no timestamps.
 */
export function passClock(device: GPUDevice): Clock | undefined {
  if (!device.features.has('timestamp-query')) return undefined
  const bytes = 16 * MOST_PASSES
  const querySet = device.createQuerySet({ type: 'timestamp', count: 2 * MOST_PASSES })
  const resolved = device.createBuffer({
    size: bytes,
    usage: GPUBufferUsage.QUERY_RESOLVE | GPUBufferUsage.COPY_SRC,
  })
  const read = device.createBuffer({ size: bytes, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST })
  const createEncoder = device.createCommandEncoder.bind(device)
  let passes: number | undefined
  device.createCommandEncoder = (descriptor) => {
    const encoder = createEncoder(descriptor)
    const begin = encoder.beginRenderPass.bind(encoder)
    encoder.beginRenderPass = (pass) => {
      if (passes === undefined) return begin(pass)
      const [beginningOfPassWriteIndex, endOfPassWriteIndex] = [2 * passes, 2 * passes + 1]
      passes++
      return begin({
        ...pass,
        timestampWrites: { querySet, beginningOfPassWriteIndex, endOfPassWriteIndex },
      })
    }
    return encoder
  }
  return async (frames) => {
    passes = 0
    frames()
    const count = passes
    passes = undefined
    if (count > MOST_PASSES) {
      throw new Error(
        `bench: too many passes to time, got ${count}, allowed: ${MOST_PASSES}; raise MOST_PASSES`,
      )
    }
    const encoder = createEncoder()
    encoder.resolveQuerySet(querySet, 0, 2 * count, resolved, 0)
    encoder.copyBufferToBuffer(resolved, 0, read, 0, 16 * count)
    device.queue.submit([encoder.finish()])
    await read.mapAsync(GPUMapMode.READ, 0, 16 * count)
    const stamps = new BigUint64Array(read.getMappedRange(0, 16 * count).slice(0))
    read.unmap()
    return Array.from({ length: count }, (_, i) => Number(stamps[2 * i + 1] - stamps[2 * i])).reduce(
      (sum, nanoseconds) => sum + nanoseconds / 1e6,
      0,
    )
  }
}

/**
 * The extension's own elapsed time.
 *
 * @returns undefined where the context has no timer queries.
 */
export function queryClock(gl: WebGL2RenderingContext): Clock | undefined {
  const timer = gl.getExtension('EXT_disjoint_timer_query_webgl2')
  if (!timer) return undefined
  const clock: Clock = async (frames) => {
    const query = gl.createQuery()
    gl.beginQuery(timer.TIME_ELAPSED_EXT, query)
    frames()
    gl.endQuery(timer.TIME_ELAPSED_EXT)
    gl.flush()
    // Results come between tasks of the page only.
    while (!gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE)) {
      await new Promise((resolve) => setTimeout(resolve))
    }
    const nanoseconds = gl.getQueryParameter(query, gl.QUERY_RESULT)
    gl.deleteQuery(query)
    // The adapter changed its clock meanwhile: the figure means nothing.
    return gl.getParameter(timer.GPU_DISJOINT_EXT) ? clock(frames) : nanoseconds / 1e6
  }
  return clock
}
