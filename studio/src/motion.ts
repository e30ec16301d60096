/** Whether the user has asked the system for less motion: then nothing moves in transitions. */
export const reducedMotion = matchMedia('(prefers-reduced-motion: reduce)')
