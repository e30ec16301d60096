import type { ReadonlySignal } from '@preact/signals'
import type { Contribution } from 'furrow/internal'
import type { DriverEditor } from '../../session/driver-editor.ts'
import type { PanelModel } from '../model.ts'

/** Context of driver forms. */
export interface DriverContext {
  readonly model: PanelModel
  readonly editor: DriverEditor
  /** Area name. */
  readonly area: string
  /** Names of the face's blendshapes and of the document's areas. */
  readonly targets: readonly string[]
  readonly areas: readonly string[]
  /** Returns the set blendshapes with their weights. */
  pose(): Map<string, number>
  /** Contributions of the document's drivers, per frame and at a readable rate. */
  readonly now: ReadonlySignal<readonly (Contribution | null)[]>
  readonly slow: ReadonlySignal<readonly (Contribution | null)[]>
}

/** Props of a driver form. `index` is the driver's index in the document. */
export interface FormProps<Driver> {
  readonly driver: Driver
  readonly index: number
  readonly context: DriverContext
}
