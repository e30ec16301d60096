import type { ComponentChildren } from 'preact'

interface SectionProps {
  title: string
  /** Of the list or field set in it. */
  id?: string
  /** Beside the title: buttons, counts. */
  aside?: ComponentChildren
  /** Whether it is unfolded at first. */
  open?: boolean
  /** Called when it is folded or unfolded. */
  onToggle?(isOpen: boolean): void
  children: ComponentChildren
}

/** A part of the panel that folds. */
export function Section({ title, id, aside, open = true, onToggle, children }: SectionProps) {
  return (
    <details class="section" open={open} onToggle={({ currentTarget }) => onToggle?.(currentTarget.open)}>
      <summary>
        <h2 id={id && `${id}-title`}>{title}</h2>
      </summary>
      {aside && <div class="aside">{aside}</div>}
      {children}
    </details>
  )
}
