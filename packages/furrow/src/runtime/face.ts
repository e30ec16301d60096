import { Activations } from './activations.ts'
import type { AreaSlots } from './area-slots.ts'

/** Activations of one face: a mesh or one of its instances. */
export class Face {
  slots: AreaSlots
  readonly activations: Activations
  /** Resting activations, to which drivers add. */
  readonly resting: Activations

  /**
   * @param slots slots of the areas, in the same order.
   * @param areas areas with resting activations.
   */
  constructor(slots: AreaSlots, areas: readonly { name: string; activation?: number }[]) {
    this.slots = slots
    this.activations = new Activations(areas, 'Wrinkles')
    this.resting = new Activations(areas, 'Wrinkles')
    for (const { name, activation } of areas) this.setResting(name, activation ?? 0)
  }

  /** Sets a resting activation. Also sets the activation, until drivers run. */
  setResting(area: string, value: number): void {
    this.resting.set(area, value)
    this.activations.set(area, value)
  }

  /** Changes the list of areas. Existing names keep their activations. */
  rebind(slots: AreaSlots, areas: readonly { name: string }[]): void {
    this.slots = slots
    this.activations.rebind(areas)
    this.resting.rebind(areas)
  }
}
