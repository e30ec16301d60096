import type { ComponentChildren } from 'preact'

interface SectionProps {
  title: string
  /** Of the list or field set in it. */
  id?: string
  /** Beside the title: buttons, counts. */
  aside?: ComponentChildren
  /** Whether it is unfolded at first. */
  open?: boolean
  children: ComponentChildren
}

/** A part of the panel that folds. */
export function Section({ title, id, aside, open = true, children }: SectionProps) {
  return (
    <details class="section" open={open}>
      <summary>
        <h2 id={id && `${id}-title`}>{title}</h2>
      </summary>
      {aside && <div class="aside">{aside}</div>}
      {children}
    </details>
  )
}
