import { loadFace } from '../../stage/face.ts'
import type { RendererKind } from '../../stage/stage.ts'
import type { Case, Plan } from '../case.ts'
import type { Measured } from '../report.ts'
import type { Bench } from './bench.ts'
import { type CrowdKind, measureCrowd } from './crowd.ts'
import { measure } from './measure.ts'
import { createScene } from './scene.ts'
import { createTimedRenderer, type TimedRenderer } from './timed-renderer.ts'
import { measureUpdates, type UpdateTimes } from './updates.ts'
import { measureWalkers } from './walkers.ts'

/** Functions that the benchmark's page defines as the global `bench`, so that the process that opens the page can call them. */
export interface BenchPage {
  /**
   * Creates the scene that the other functions measure.
   *
   * @param width picture width, pixels.
   * @param height picture height, pixels.
   * @param url address of the face's glTF file.
   */
  open(
    renderer: RendererKind,
    width: number,
    height: number,
    url: string,
  ): Promise<Pick<TimedRenderer, 'adapter' | 'timing'>>
  measure(benchCase: Case, plan: Plan): Promise<Measured[]>
  /** Measures the fraction of a crowd's frame time that is spent on influence maps, 0..1. Returns one number per round. */
  measureCrowd(kind: CrowdKind, plan: Plan): Promise<number[]>
  /** Measures the frame time of walking characters with folds, divided by that without. Returns one number per round. */
  measureWalkers(url: string, count: number, plan: Plan): Promise<number[]>
  /** Measures how long a frame waits for a change of a layer's normal map. */
  measureUpdates(plan: Plan): Promise<UpdateTimes>
}

let bench: Bench

const page: BenchPage = {
  async open(renderer, width, height, url) {
    const face = await loadFace(url)
    const timedRenderer = await createTimedRenderer(renderer, width, height)
    bench = { renderer, timedRenderer, face, ...createScene(face, width / height) }
    return { adapter: timedRenderer.adapter, timing: timedRenderer.timing }
  },
  measure: (benchCase, plan) => measure(bench, benchCase, plan),
  measureCrowd: (kind, plan) => measureCrowd(bench, kind, plan),
  measureWalkers: (url, count, plan) => measureWalkers(bench, url, count, plan),
  measureUpdates: (plan) => measureUpdates(bench, plan),
}
Object.assign(globalThis, { bench: page })
