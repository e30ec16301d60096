import { StudioPage } from '../studio-page.mjs'
import { WorkerSessions } from '../worker-sessions.mjs'

const MEGABYTE = 2 ** 20

/** Measures the heaps of the page and its workers after many brush strokes and garbage collection. */
export async function measureMemory(bench, add) {
  const studio = await StudioPage.open(bench)
  const { page } = studio
  const session = await page.context().newCDPSession(page)
  const workers = await WorkerSessions.attach(session)
  await studio.openProject(await bench.files.project(10))
  await studio.button('New region').click()
  await studio.chooseTool('Paint')
  await studio.waitForIdle()
  const before = await heapOf(session)
  for (let i = 0; i < bench.strokes; i++) {
    const [x, y] = [0.42 + 0.16 * ((i * 0.618) % 1), 0.2 + 0.45 * ((i * 0.367) % 1)]
    await studio.drag(await studio.pointAt(x, y), await studio.pointAt(x + 0.02, y), 1)
  }
  await studio.waitForIdle()
  const after = await heapOf(session)
  add('heap of the page, MB', after / MEGABYTE)
  add(`of which ${bench.strokes} brush strokes, MB`, (after - before) / MEGABYTE)
  add('heaps of its workers, MB', (await workers.heap()) / MEGABYTE)
  await studio.close()
}

async function heapOf(session) {
  await session.send('HeapProfiler.collectGarbage')
  const { usedSize, backingStorageSize = 0 } = await session.send('Runtime.getHeapUsage')
  return usedSize + backingStorageSize
}
