import { effect, type ReadonlySignal, signal } from '@preact/signals'
import { reducedMotion } from '../motion.ts'
import { type LightDirection, lightPosition } from './light-direction.ts'
import type { Orbit } from './orbit.ts'
import type { Viewer } from './viewer.ts'

/** Where the key light is at first: at the upper left. */
export const KEY_LIGHT: LightDirection = { yaw: -46, pitch: 44 }
/** Light that grazes the skin, so that lines show; from where the side with wrinkles is. */
const SIDE_LIGHT: LightDirection = { yaw: 72, pitch: 36 }

export interface StagingParts {
  viewer: ReadonlySignal<Viewer | null>
  orbit(): Orbit | null
  /** Requests the next frame. */
  wake(): void
}

/** The light and the turntable of the stage, whichever face is on it. */
export class Staging {
  readonly light = signal<LightDirection>(KEY_LIGHT)
  readonly turntable = signal(false)
  /** Whether lines are lit from the side, whatever the light. */
  readonly isSideLit = signal(false)

  constructor({ viewer, orbit, wake }: StagingParts) {
    effect(() => {
      const light = this.isSideLit.value ? SIDE_LIGHT : this.light.value
      const stage = viewer.value?.stage
      if (!stage) return
      lightPosition(light, stage.key.position)
      wake()
    })
    effect(() => {
      viewer.value
      const camera = orbit()
      if (camera) camera.turntable = this.turntable.value
      wake()
    })
    reducedMotion.addEventListener('change', ({ matches }) => {
      if (matches) this.turntable.value = false
    })
  }
}
