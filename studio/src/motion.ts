/** Whether the system requests reduced motion, which disables transitions. */
export const reducedMotion = matchMedia('(prefers-reduced-motion: reduce)')
