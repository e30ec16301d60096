import { BANK_WIDTHS } from 'furrow/internal'
import { useId } from 'preact/hooks'
import type { LineEditor, LineMode, LineShape } from '../lines/line-editor.ts'
import { Choice } from './controls/choice.tsx'
import { NumberSlider } from './controls/number-slider.tsx'
import { Section } from './controls/section.tsx'
import { LineChoice, LinePoints } from './line-choice.tsx'
import type { PanelModel } from './model.ts'

const MODES: readonly { value: LineMode; label: string; title?: string }[] = [
  { value: 'off', label: 'Off' },
  { value: 'edit', label: 'Edit', title: 'Click a line, drag its points' },
  { value: 'draw', label: 'Draw', title: 'Draw a new line on the skin' },
]

/** Controls of the chosen line, or of new lines. */
export function Lines({ model }: { model: PanelModel }) {
  const { lines, session, actions } = model
  const mode = lines.mode.value
  const chosen = lines.chosen.value
  const shape = mode === 'draw' ? lines.shape.value : chosen
  return (
    <Section title="Lines">
      <div class="settings">
        <Choice
          label="Pointer"
          options={MODES}
          value={mode}
          onChange={(value) => {
            lines.mode.value = value
          }}
        />
        {mode === 'edit' && <LineChoice editor={lines} strokes={session.document.value?.strokes ?? []} />}
        <p class="hint">{HINTS[mode === 'edit' && chosen ? 'chosen' : mode]}</p>
        {mode === 'edit' && chosen && <LinePoints editor={lines} actions={actions} />}
        {mode !== 'off' && shape && (
          <>
            <Shape shape={shape} editor={lines} attempt={actions.attempt} />
            <Membership
              group={mode === 'draw' ? lines.group.value : (chosen?.group ?? '')}
              layer={mode === 'draw' ? lines.layer.value : (chosen?.layer ?? '')}
              isNew={mode === 'draw'}
              groups={groupsOf(session)}
              layers={session.document.value?.layers.map(({ name }) => name) ?? []}
              editor={lines}
              attempt={actions.attempt}
            />
          </>
        )}
        {mode === 'edit' && chosen && <Operations editor={lines} attempt={actions.attempt} />}
      </div>
    </Section>
  )
}

const HINTS: Record<LineMode | 'chosen', string> = {
  off: 'Every wrinkle is a line: edit those that are there, or draw your own.',
  edit: 'Click a line on the face, or choose it above.',
  chosen: 'Drag a point to move it. Shift+click or double-click adds one, Delete removes it.',
  draw: 'Draw on the skin. Drag beside the face to turn it.',
}

type Attempt = PanelModel['actions']['attempt']

interface ControlsProps {
  editor: LineEditor
  attempt: Attempt
}

/** Minimum, maximum and step of each slider. */
const WIDTH = [0.2, 12, 0.1] as const
const DEPTH = [0, 3, 0.02] as const
const FRACTION = [0, 1, 0.01] as const
/** Width of the raised sides, millimetres. */
const BANK = [0.2, 30, 0.1] as const
const LEAN = [-0.9, 0.9, 0.05] as const
/** Fraction of the length, at each end. Up to one half, so that the ends do not overlap. */
const TAPER = [0, 0.5, 0.01] as const

function Shape({ shape, editor, attempt }: ControlsProps & { shape: LineShape }) {
  const { width, depth, softness, shoulder, bank, lean = 0, taper } = shape
  const slider = (
    label: string,
    range: readonly [number, number, number],
    value: number,
    fields: (value: number) => Partial<LineShape>,
  ) => (
    <NumberSlider
      label={label}
      range={range}
      value={value}
      onMove={(next) => attempt(() => editor.setShape(fields(next)))}
      onRest={() => editor.settle()}
    />
  )
  return (
    <div>
      {slider('Width, mm', WIDTH, width, (value) => ({ width: value }))}
      {slider('Depth, mm', DEPTH, depth, (value) => ({ depth: value }))}
      {slider('Softness', FRACTION, softness, (value) => ({ softness: value }))}
      {slider('Shoulders', FRACTION, mean(shoulder), (value) => ({ shoulder: [value, value] }))}
      {slider('Banks, mm', BANK, bank ? mean(bank) : BANK_WIDTHS * width, (value) => ({
        bank: [value, value],
      }))}
      {slider('Lean', LEAN, lean, (value) => ({ lean: value }))}
      {slider('Taper', TAPER, mean(taper), (value) => ({ taper: [value, value] }))}
    </div>
  )
}

function mean([a, b]: readonly [number, number]): number {
  return (a + b) / 2
}

interface MembershipProps extends ControlsProps {
  group: string
  layer: string
  /** Whether the fields apply to new lines, whose default comes from the area below them. */
  isNew: boolean
  groups: readonly string[]
  layers: readonly string[]
}

/** Area and layer of a line. */
function Membership({ group, layer, isNew, groups, layers, editor, attempt }: MembershipProps) {
  const id = useId()
  return (
    <>
      <div class="setting">
        <label for={`${id}-group`}>Group</label>
        <input
          id={`${id}-group`}
          type="search"
          list={`${id}-groups`}
          value={group}
          placeholder={isNew ? 'The area under the line' : 'A new name makes an area'}
          onChange={({ currentTarget }) => attempt(() => editor.setGroup(currentTarget.value.trim()))}
        />
        <datalist id={`${id}-groups`}>
          {groups.map((name) => (
            <option key={name} value={name} />
          ))}
        </datalist>
      </div>
      <div class="setting">
        <label for={`${id}-layer`}>Layer</label>
        <select
          id={`${id}-layer`}
          value={layer}
          onChange={({ currentTarget }) => attempt(() => editor.setLayer(currentTarget.value))}
        >
          {isNew && <option value="">That of the area</option>}
          {layers.map((name) => (
            <option key={name} value={name}>
              {name}
            </option>
          ))}
        </select>
      </div>
    </>
  )
}

function groupsOf({ document }: PanelModel['session']): string[] {
  const { areas, strokes } = document.value ?? { areas: [], strokes: [] }
  return [...new Set([...areas.map(({ name }) => name), ...strokes.flatMap(({ group }) => group ?? [])])]
}

function Operations({ editor, attempt }: ControlsProps) {
  const buttons: readonly [label: string, title: string, action: () => void, isDisabled?: boolean][] = [
    ['Smooth', 'Moves its points towards a smoother line', () => editor.smooth()],
    ['Split', 'At the chosen point, or in the middle', () => editor.split()],
    ['Mirror', 'Adds its mirror image', () => editor.mirror()],
    ['Delete line', '', () => editor.removeLine()],
    ['Delete point', 'The chosen one', () => editor.remove(), editor.point.value < 0],
  ]
  return (
    <fieldset class="grid lines-actions" aria-label="Chosen line">
      {buttons.map(([label, title, action, isDisabled]) => (
        <button key={label} type="button" title={title} disabled={isDisabled} onClick={() => attempt(action)}>
          {label}
        </button>
      ))}
    </fieldset>
  )
}
