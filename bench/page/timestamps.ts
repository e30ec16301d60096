/// <reference types="@webgpu/types" />
/**
 * Runs `frames`, which draws one or more frames. Returns their total GPU time in milliseconds, or the elapsed time if the GPU has no
 * timestamp queries.
 */
export type Clock = (frames: () => void) => Promise<number>

/** Maximum number of render passes timed together. WebGPU limits a query set to 4096 entries, and each pass needs two. */
const MAX_PASSES = 2048

/**
 * Creates a clock for WebGPU that sums the GPU time of all render passes, including those that generate mipmaps. Idle time between passes is
 * not counted.
 *
 * @returns undefined if the device has no timestamp queries.
 */
export function passClock(device: GPUDevice): Clock | undefined {
  if (!device.features.has('timestamp-query')) return undefined
  const bytes = 16 * MAX_PASSES
  const querySet = device.createQuerySet({ type: 'timestamp', count: 2 * MAX_PASSES })
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
    if (count > MAX_PASSES) {
      throw new Error(
        `bench: too many passes to time, got ${count}, allowed: at most ${MAX_PASSES}; time fewer frames`,
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
 * Creates a clock for WebGL that measures elapsed GPU time with `EXT_disjoint_timer_query_webgl2`.
 *
 * @returns undefined if the context has no timer queries.
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
    // The browser makes the result available only after the current task has ended.
    while (!gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE)) {
      await new Promise((resolve) => setTimeout(resolve))
    }
    const nanoseconds = gl.getQueryParameter(query, gl.QUERY_RESULT)
    gl.deleteQuery(query)
    // The result is invalid if the GPU's clock was disjoint, for example after a change of its frequency. Then the frames run again.
    return gl.getParameter(timer.GPU_DISJOINT_EXT) ? clock(frames) : nanoseconds / 1e6
  }
  return clock
}
