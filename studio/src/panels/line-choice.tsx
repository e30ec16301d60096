import { useId } from 'preact/hooks'
import type { LayerStroke } from '../document/document.ts'
import { LINE, linePointHint, linePointLabel } from '../labels/lines.ts'
import { regionLabel } from '../labels/names.ts'
import type { LineEditor } from '../lines/line-editor.ts'
import { type ShortcutName, shortcutOf } from '../shortcuts.ts'
import { LabelledGroup } from './controls/labelled-group.tsx'
import type { PanelModel } from './model.ts'

/** Movement of a point per key press, without and with Shift, CSS pixels. */
const STEP = 2
const LARGE_STEP = 20

/** Select for the line to edit. Users can also click on a line on the face. */
export function LineChoice({ editor, strokes }: { editor: LineEditor; strokes: readonly LayerStroke[] }) {
  const id = useId()
  return (
    <div class="setting">
      <label for={id}>{LINE.line}</label>
      <select
        id={id}
        value={editor.chosen.value ? strokes.indexOf(editor.chosen.value) : ''}
        onChange={({ currentTarget: { value } }) =>
          editor.choose(value === '' ? null : strokes[Number(value)])
        }
      >
        <option value="">{LINE.none}</option>
        {namesOf(strokes).map((name, i) => (
          <option key={i} value={i}>
            {name}
          </option>
        ))}
      </select>
    </div>
  )
}

/** Returns a name for each line: its region, with a number if the region has several lines. */
function namesOf(strokes: readonly LayerStroke[]): string[] {
  const groups = strokes.map(({ group }) => group ?? LINE.noGroup)
  const labels = new Map(groups.map((group) => [group, regionLabel(group)]))
  const counts = new Map<string, number>()
  const numbers = groups.map((group) => {
    const number = (counts.get(group) ?? 0) + 1
    counts.set(group, number)
    return number
  })
  return groups.map((group, i) => {
    const label = labels.get(group)!
    return counts.get(group) === 1 ? label : `${label} ${numbers[i]}`
  })
}

/** Buttons for the points and forks of the chosen line. Arrow keys move the point whose button has the focus. */
export function LinePoints({ editor, actions }: { editor: LineEditor; actions: PanelModel['actions'] }) {
  const handles = editor.handles.value
  const count = handles.length
  const point = editor.point.value
  const onKeyDown = (event: KeyboardEvent, index: number) => {
    const name = shortcutOf('linePoint', event)
    if (!name) return
    event.preventDefault()
    editor.point.value = index
    if (name === 'remove') {
      actions.attempt(() => editor.remove())
      // The focus is now on the next point, so choose this point.
      if (editor.chosen.peek()) editor.point.value = Math.min(index, editor.handles.peek().length - 1)
      return
    }
    const step = event.shiftKey ? LARGE_STEP : STEP
    const [right, down] = DIRECTIONS[name]
    actions.moveLinePoint(right * step, down * step)
  }
  return (
    <LabelledGroup label={LINE.points}>
      <div class="points">
        {handles.map(({ knot, fork }, i) => (
          <button
            key={i}
            type="button"
            class={fork ? 'fork' : ''}
            aria-pressed={i === point}
            aria-label={linePointLabel(i + 1, count, Boolean(fork))}
            title={linePointHint({ isFork: Boolean(fork), isRemovable: knot >= 0 })}
            onFocus={() => {
              editor.point.value = i
            }}
            onClick={() => {
              editor.point.value = i
            }}
            onKeyDown={(event) => onKeyDown(event, i)}
            onKeyUp={() => editor.settle()}
          >
            {i + 1}
          </button>
        ))}
      </div>
    </LabelledGroup>
  )
}

const DIRECTIONS: Record<
  Exclude<ShortcutName<'linePoint'>, 'remove'>,
  readonly [right: number, down: number]
> = {
  left: [-1, 0],
  right: [1, 0],
  up: [0, -1],
  down: [0, 1],
}
