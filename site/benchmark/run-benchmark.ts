/** The quick benchmark of bench/, on the visitor's own GPU. */

import { listCases, PLANS, RENDERER_KINDS } from '../../bench/case.ts'
import { measure } from '../../bench/page/measure.ts'
import { createScene } from '../../bench/page/scene.ts'
import { createTimedRenderer } from '../../bench/page/timed-renderer.ts'
import { type Result, toResults, toTable } from '../../bench/report.ts'
import { loadFace } from '../../stage/face.ts'
import type { RendererKind } from '../../stage/stage.ts'

const SIZE = { width: 800, height: 600 }

/**
 * Measures, and returns what can be pasted into an issue: adapters, browser and a table in Markdown.
 *
 * @param face address of `faces/human.glb`.
 * @param progress called with the fraction that is done, 0..1.
 * @throws Error if nothing could be measured.
 */
export async function runBenchmark(face: string, progress: (fraction: number) => void): Promise<string> {
  const kinds = RENDERER_KINDS.filter((kind) => kind === 'webgl' || 'gpu' in navigator)
  const cases = listCases(true)
  const results: Result[] = []
  const notes: string[] = []
  for (const [i, kind] of kinds.entries()) {
    try {
      const report = (k: number) => progress((i + k / cases.length) / kinds.length)
      results.push(...(await runOn(kind, face, report)))
    } catch (error) {
      notes.push(`${kind}: ${(error as Error).message}`)
    }
  }
  if (results.length === 0) throw new Error(notes.join('; '))
  const adapters = results.map(
    ({ renderer, adapter, timing }) => `${renderer}: ${adapter}, timed by ${timing}`,
  )
  return [...new Set(adapters), ...notes, navigator.userAgent, '', toTable(results)].join('\n')
}

async function runOn(renderer: RendererKind, url: string, report: (done: number) => void): Promise<Result[]> {
  const { width, height } = SIZE
  const face = await loadFace(url)
  const timedRenderer = await createTimedRenderer(renderer, width, height)
  const { adapter, timing } = timedRenderer
  const bench = { renderer, timedRenderer, face, ...createScene(face, width / height) }
  const results: Result[] = []
  for (const [k, benchCase] of listCases(true).entries()) {
    const measured = await measure(bench, benchCase, PLANS.quick)
    results.push(...toResults(benchCase, { width, height, renderer, adapter, timing }, measured))
    report(k + 1)
  }
  return results
}
