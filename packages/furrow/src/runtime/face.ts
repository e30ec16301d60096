import { Activations } from './activations.ts'
import type { AreaSlots } from './area-slots.ts'

/** Activations of the areas of one face. A face is a mesh or one instance of a mesh. */
export class Face {
  slots: AreaSlots
  readonly activations: Activations
  /** Activations of the resting face. Drivers add to these activations. */
  readonly resting: Activations

  /**
   * @param slots slices and channels of the texture array that store the weights of areas, in the order of `areas`.
   * @param areas areas with resting activations.
   */
  constructor(slots: AreaSlots, areas: readonly { name: string; activation?: number }[]) {
    this.slots = slots
    this.activations = new Activations(areas, 'Wrinkles')
    this.resting = new Activations(areas, 'Wrinkles')
    for (const { name, activation } of areas) this.setResting(name, activation ?? 0)
  }

  /** Sets the resting activation of an area. Also sets its activation, which drivers may change in the next frame. */
  setResting(area: string, value: number): void {
    this.resting.set(area, value)
    this.activations.set(area, value)
  }

  rebind(slots: AreaSlots, areas: readonly { name: string }[]): void {
    this.slots = slots
    this.activations.rebind(areas)
    this.resting.rebind(areas)
  }
}
