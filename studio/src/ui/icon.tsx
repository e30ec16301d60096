/** Shapes of icons, as SVG paths in a square of 20 x 20. */
const PATHS = {
  select: 'M5 3l10 7-4.6.9L8 15.5z',
  draw: 'M3 14c4-8 9 2 14-8M3 17l1-3 2 2z',
  bend: 'M3 14c4 0 4-8 7-8s3 8 7 8M10 2v3M10 15v3',
  smooth: 'M2 7c3-4 3 4 6 0s3 4 5 0M2 14c6-3 10-3 16 0',
  erase: 'M8 16l-4-4 7-8 5 5-6 7zM8 16h9M7.5 8l5 5',
  paint: 'M12 3l5 5-6 6-5-5zM6 9c-3 2-1 4-4 8 4 0 7 0 9-3',
  polygon: 'M4 15L3 6l7-3 7 5-3 9z',
  sculpt: 'M2 16c4 0 4-9 8-9s4 9 8 9M10 2v3M7 4l3-2 3 2',
  mirror: 'M10 2v16M7 6L2 14h5zM13 6l5 8h-5z',
  undo: 'M7 4L3 8l4 4M3 8h8a5 5 0 010 10H8',
  redo: 'M13 4l4 4-4 4M17 8H9a5 5 0 000 10h3',
  gear: 'M10 7a3 3 0 100 6 3 3 0 000-6zM10 2v3M10 15v3M2 10h3M15 10h3M4.5 4.5l2 2M13.5 13.5l2 2M15.5 4.5l-2 2M6.5 13.5l-2 2',
  eye: 'M2 10c4-6 12-6 16 0-4 6-12 6-16 0zM10 7.5a2.5 2.5 0 100 5 2.5 2.5 0 000-5z',
  turn: 'M16 7a7 3 0 10-1 5M16 3v4h-4',
  skeleton: 'M10 2a2 2 0 100 4 2 2 0 000-4zM10 6v6M4 8h12M10 12l-4 6M10 12l4 6',
  more: 'M4 10h.1M10 10h.1M16 10h.1',
  sliders: 'M4 3v14M10 3v14M16 3v14M2 7h4M8 13h4M14 6h4',
  down: 'M5 8l5 5 5-5',
} as const

export type IconName = keyof typeof PATHS

export function Icon({ name }: { name: IconName }) {
  return (
    <svg class="icon" viewBox="0 0 20 20" aria-hidden="true">
      <path d={PATHS[name]} />
    </svg>
  )
}
