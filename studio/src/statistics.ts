import { signal } from '@preact/signals'

/** Whether the stage shows the frame time and the graphics device. */
export const isStatisticsShown = signal(false)
