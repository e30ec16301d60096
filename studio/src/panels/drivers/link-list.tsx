import { useComputed, useSignal } from '@preact/signals'
import type { Curve, Link } from 'furrow'
import { canonicalTargetName } from 'furrow/internal'
import type { ComponentChildren } from 'preact'
import {
  addLinkLabel,
  addLinkOption,
  aloneLabel,
  curveLabel,
  DRIVERS,
  factorLabel,
  LINKS,
  linkLabel,
  removeLinkLabel,
} from '../../labels/drivers.ts'
import { axisOf } from './axes.ts'
import type { DriverContext } from './context.ts'
import { CurveEditor } from './curve-editor.tsx'
import { NameSelect, optionsOf } from './fields.tsx'
import { NumberField } from './number-field.tsx'

interface LinkListProps {
  index: number
  context: DriverContext
  links: readonly Link[]
  /** Names from which the user can choose. */
  names: readonly string[]
  /** Label of the kind of input to which links refer, such as `blendshape`. */
  noun: string
  /** Driver field that contains the links. */
  field: 'targets' | 'areas'
}

/** List of a driver's links: the blendshapes or areas that it reads, each with a factor and an optional curve. */
export function LinkList({ index, context, links, names, noun, field }: LinkListProps) {
  const { editor } = context
  const set = (next: readonly Link[]) => editor.set(index, field, { [field]: next })
  const change = (i: number, fields: Partial<Link>) => {
    set(links.map((link, k) => (k === i ? { ...link, ...fields } : link)))
    editor.settle()
  }
  const used = new Set(links.map(({ name }) => canonicalTargetName(name)))
  const free = names.filter((name) => !used.has(canonicalTargetName(name)))
  return (
    <div class="links">
      {links.map((link, i) => (
        <LinkRow
          key={i}
          {...{ index, context, link, names, noun }}
          position={i}
          isOnly={links.length === 1}
          onChange={(fields) => change(i, fields)}
          curve={<LinkCurve {...{ index, context, links, field }} position={i} />}
          onRemove={() => {
            set(links.filter((_, k) => k !== i))
            editor.settle()
          }}
        />
      ))}
      {free.length > 0 && (
        <NameSelect
          label={addLinkLabel(noun)}
          value=""
          options={[['', addLinkOption(noun)], ...optionsOf(free)]}
          onChange={(name) => {
            if (name === '') return
            set([...links, { name, weight: 1 }])
            editor.settle()
          }}
        />
      )}
    </div>
  )
}

interface LinkRowProps {
  index: number
  context: DriverContext
  link: Link
  /** Index of the link in the driver. */
  position: number
  names: readonly string[]
  noun: string
  /** Whether this is the driver's only link. */
  isOnly: boolean
  onChange(fields: Partial<Link>): void
  /** Editor of the link's curve. */
  curve: ComponentChildren
  onRemove(): void
}

function LinkRow({
  index,
  context: { slow },
  link,
  position,
  names,
  noun,
  isOnly,
  onChange,
  curve: editor,
  onRemove,
}: LinkRowProps) {
  const { name, weight, curve } = link
  const isOpen = useSignal(false)
  const part = useComputed(() => slow.value[index]?.links[position]?.toFixed(2) ?? '')
  return (
    <>
      <div class="link">
        <NameSelect
          label={linkLabel(noun, position + 1)}
          value={name}
          options={optionsOf(names)}
          onChange={(next) => onChange({ name: next })}
        />
        <NumberField
          label={factorLabel(name)}
          isLabelHidden
          value={weight}
          step={0.05}
          range={[-1000, 1000]}
          onChange={(next) => onChange({ weight: next })}
        />
        <output class="part" title={DRIVERS.contribution} aria-live="off">
          {part}
        </output>
        <button
          type="button"
          class={`toggle ${curve ? 'bent' : ''}`}
          title={LINKS.curve}
          aria-label={curveLabel(name)}
          aria-expanded={isOpen.value}
          onClick={() => {
            isOpen.value = !isOpen.value
          }}
        >
          <svg class="bend" viewBox="0 0 16 16" aria-hidden="true">
            <path d="M2 13C8 13 8 3 14 3" />
          </svg>
        </button>
        <button
          type="button"
          class="remove"
          title={LINKS.remove}
          aria-label={removeLinkLabel(name)}
          disabled={isOnly}
          onClick={onRemove}
        >
          ×
        </button>
      </div>
      {isOpen.value && editor}
    </>
  )
}

interface LinkCurveProps extends Pick<LinkListProps, 'index' | 'context' | 'links' | 'field'> {
  /** Index of the link in the driver. */
  position: number
}

/** Editor for the curve of a single link. */
export function LinkCurve({ index, context: { editor, now }, links, field, position }: LinkCurveProps) {
  const { name, curve = LINE } = links[position]
  const input = useComputed(() => now.value[index]?.inputs[position] ?? null)
  return (
    <CurveEditor
      label={aloneLabel(name)}
      curve={curve}
      axis={axisOf('fraction', name, curve)}
      outputs={[-1000, 1000]}
      now={input}
      onMove={(next) => {
        const bent = links.map((other, k) => (k === position ? { ...other, curve: next } : other))
        editor.set(index, `curve of ${field} ${position}`, { [field]: bent })
      }}
      onRest={() => editor.settle()}
    />
  )
}

const LINE: Curve = [
  [0, 0],
  [1, 1],
]
