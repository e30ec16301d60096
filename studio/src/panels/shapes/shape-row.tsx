import { useComputed } from '@preact/signals'
import { useRef } from 'preact/hooks'
import { SHAPES, showShapeLabel } from '../../labels/blendshapes.ts'
import type { ShapeRow as Row } from '../../session/shape-editor.ts'
import type { PanelModel } from '../model.ts'
import { confidenceOf, evidenceLabel, isUnknown } from './recognised.ts'
import { ShapeChoice } from './shape-choice.tsx'

interface ShapeRowProps {
  row: Row
  isHidden: boolean
  model: PanelModel
}

/**
 * Row for a blendshape: its name, its recognised shape and the confidence. While the pointer or the focus is on the row, the face shows the
 * blendshape.
 */
export function ShapeRow({ row, isHidden, model }: ShapeRowProps) {
  const { name, correction } = row
  const confidence = confidenceOf(row)
  const { hovered } = model
  const isShown = useComputed(() => hovered.value?.kind === 'shape' && hovered.value.name === name)
  const wasShown = useRef(false)
  const show = () => {
    if (!isShown.peek()) hovered.value = { kind: 'shape', name }
  }
  const hide = () => {
    if (isShown.peek()) hovered.value = null
  }
  return (
    <li
      hidden={isHidden}
      class={`shape${isUnknown(row) ? ' unknown' : ''}${correction === undefined ? '' : ' corrected'}`}
      // Ignore touches. Also ignore events that scrolling causes under a resting mouse.
      onPointerMove={({ pointerType, movementX, movementY }) => {
        if (pointerType === 'mouse' && (movementX !== 0 || movementY !== 0)) show()
      }}
      onPointerLeave={({ pointerType }) => pointerType === 'mouse' && hide()}
      onFocusIn={show}
      onFocusOut={hide}
    >
      <button
        type="button"
        class="show"
        // Tab skips this button, because focusing the select in this row also shows the blendshape.
        tabIndex={-1}
        aria-pressed={isShown}
        title={showShapeLabel(name)}
        onPointerDown={({ pointerType }) => {
          wasShown.current = pointerType !== 'mouse' && isShown.peek()
        }}
        onClick={() => (wasShown.current ? hide() : show())}
      >
        {name}
      </button>
      {confidence === undefined ? (
        <span class="evidence">{isUnknown(row) ? SHAPES.unknown : evidenceLabel(row)}</span>
      ) : (
        <span class="evidence">
          <span class="confidence" style={{ '--value': confidence }} />
          <span class="percent">{Math.round(100 * confidence)}%</span>
          <span class="reason">{evidenceLabel(row)}</span>
        </span>
      )}
      <ShapeChoice row={row} model={model} />
    </li>
  )
}
