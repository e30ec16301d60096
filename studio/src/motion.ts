/** Media query that matches if the system asks for reduced motion. The page then has no transitions. */
export const reducedMotion = matchMedia('(prefers-reduced-motion: reduce)')
