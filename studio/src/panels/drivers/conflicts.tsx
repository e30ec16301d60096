import { useComputed } from '@preact/signals'
import type { ConflictDriver } from 'furrow'
import { canonicalTargetName } from 'furrow/internal'
import { conflictsOf } from '../../document/driver-problems.ts'
import { CONFLICTS, removeConflictLabel, takenLabel } from '../../labels/drivers.ts'
import type { DriverContext } from './context.ts'
import { NameSelect, optionsOf } from './fields.tsx'

/** List of conflicts: pairs of blendshapes that cancel each other, such as raising and lowering a brow. */
export function Conflicts({ context }: { context: DriverContext }) {
  const { model, editor, area, targets } = context
  const drivers = model.session.document.value?.drivers ?? []
  const own = conflictsOf(drivers, area)
  const first =
    model.viewer.value?.driven.drivers.targetsOf(area).find((name) => targets.includes(name)) ?? targets[0]
  if (targets.length < 2) return null
  return (
    <details class="conflicts">
      <summary>
        {CONFLICTS.title}
        <span>{own.length}</span>
      </summary>
      <p class="hint">{CONFLICTS.hint}</p>
      {own.map((index) => (
        <Conflict key={index} index={index} driver={drivers[index] as ConflictDriver} context={context} />
      ))}
      <div class="add">
        <button
          type="button"
          onClick={() => editor.add({ type: 'conflict', targets: [first, oppositeOf(first, targets)] })}
        >
          {CONFLICTS.add}
        </button>
      </div>
    </details>
  )
}

interface ConflictProps {
  index: number
  driver: ConflictDriver
  context: DriverContext
}

function Conflict({ index, driver, context: { model, editor, targets, slow } }: ConflictProps) {
  const [a, b] = driver.targets
  const taken = useComputed(() => {
    slow.value
    const dials = model.viewer.value?.targets ?? []
    const read = (name: string) => dials.find((dial) => dial.name === canonicalTargetName(name))?.read() ?? 0
    const common = Math.min(read(a), read(b))
    return common > 0 ? takenLabel(common) : ''
  })
  const choose = (position: number, name: string) => {
    editor.set(index, 'targets', { targets: driver.targets.map((old, i) => (i === position ? name : old)) })
    editor.settle()
  }
  return (
    <div class="conflict">
      <NameSelect
        label={CONFLICTS.one}
        value={a}
        options={optionsOf(targets)}
        onChange={(name) => choose(0, name)}
      />
      <NameSelect
        label={CONFLICTS.other}
        value={b}
        options={optionsOf(targets)}
        onChange={(name) => choose(1, name)}
      />
      <button
        type="button"
        class="remove"
        title={CONFLICTS.remove}
        aria-label={removeConflictLabel(a, b)}
        onClick={() => editor.remove(index)}
      >
        ×
      </button>
      <p class="hint reading">{taken}</p>
    </div>
  )
}

/** Parts of blendshape names and their opposites. Replacing a part by its opposite gives the name of an opposite blendshape. */
const OPPOSITES: readonly (readonly [RegExp, string])[] = [
  [/^browInnerUp$/, 'browDownLeft'],
  [/^browOuterUp/, 'browDown'],
  [/^browDown/, 'browOuterUp'],
  [/^mouthSmile/, 'mouthFrown'],
  [/^mouthFrown/, 'mouthSmile'],
  [/^eyeWide/, 'eyeBlink'],
  [/^eyeSquint/, 'eyeWide'],
  [/^eyeBlink/, 'eyeWide'],
  [/^mouthPucker$/, 'mouthStretchLeft'],
]

/** Suggests the opposite of a blendshape, if the face has it. Otherwise suggests the first blendshape with another name. */
function oppositeOf(name: string, targets: readonly string[]): string {
  const known = OPPOSITES.find(([part]) => part.test(name))
  const opposite = known && name.replace(...known)
  return targets.find((target) => target === opposite) ?? targets.find((target) => target !== name)!
}
