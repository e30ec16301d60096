import { useSignal } from '@preact/signals'
import type { WrinkleDriver } from 'furrow'
import { useId } from 'preact/hooks'
import type { StudioDocument } from '../../document/document.ts'
import { DRIVERS } from '../../labels/drivers.ts'
import { faceOf } from '../../open/avatar.ts'
import { jointsOf } from '../../viewer/pose/joints.ts'
import { muscleAxis } from '../../viewer/pose/muscle-axis.ts'
import type { DriverContext } from './context.ts'
import type { AreaDriverType, Drivable } from './types/driver-type.ts'
import { AREA_DRIVER_TYPES, createDriver, driverTypeOf } from './types/types.ts'

interface AddDriverProps {
  document: StudioDocument
  context: DriverContext
  onAdd(driver: WrinkleDriver): void
}

/** Select for the type of a new driver. Types that the face does not support are disabled. */
export function AddDriver({ document, context, onAdd }: AddDriverProps) {
  const id = useId()
  const type = useSignal<AreaDriverType>('morph')
  const { area } = context
  const viewer = context.model.viewer.value
  if (!viewer) return null
  const make = (kind: AreaDriverType) => createDriver(kind, area, document, drivable(context, document))
  const isPossible = (kind: AreaDriverType) => kind === 'muscle' || make(kind) !== null
  return (
    <div class="add-driver">
      <label for={id} class="hidden">
        {DRIVERS.type}
      </label>
      <select
        id={id}
        value={type.value}
        onChange={({ currentTarget }) => {
          type.value = currentTarget.value as AreaDriverType
        }}
      >
        {AREA_DRIVER_TYPES.map((each) => (
          <option key={each} value={each} disabled={!isPossible(each)}>
            {driverTypeOf(each)?.label}
          </option>
        ))}
      </select>
      <button
        type="button"
        onClick={() => {
          const driver = make(type.value)
          if (driver) onAdd(driver)
        }}
      >
        {DRIVERS.add}
      </button>
    </div>
  )
}

/** Collects the inputs that new drivers can have. Computes a muscle only when it is needed, because this is slow. */
function drivable({ model, area, targets, pose }: DriverContext, document: StudioDocument): Drivable {
  const { avatar } = model.viewer.peek()!
  return {
    pose: pose(),
    targets,
    joints: jointsOf(avatar.root),
    muscle: () => {
      const { weights } = document.areas.find(({ name }) => name === area)!
      return muscleAxis(faceOf(avatar).skin, weights)
    },
  }
}
