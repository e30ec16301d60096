/** Elements of index.html. */
export interface Page {
  stage: HTMLElement
  viewport: HTMLElement
  divider: HTMLElement
  sideWith: HTMLElement
  views: HTMLElement
  textureToggle: HTMLButtonElement
  texture: HTMLElement
  loading: HTMLElement
  progress: HTMLProgressElement
  loadingText: HTMLElement
  readout: HTMLElement
  backend: HTMLElement
  adapter: HTMLElement
  frameTime: HTMLElement
  graph: HTMLCanvasElement
  errors: HTMLElement
  notes: HTMLElement
  dropping: HTMLElement
}

const IDS: Record<keyof Page, string> = {
  stage: 'stage',
  viewport: 'viewport',
  divider: 'divider',
  sideWith: 'side-with',
  views: 'views',
  textureToggle: 'texture-toggle',
  texture: 'texture',
  loading: 'loading',
  progress: 'progress',
  loadingText: 'loading-text',
  readout: 'readout',
  backend: 'backend',
  adapter: 'adapter',
  frameTime: 'frame-time',
  graph: 'graph',
  errors: 'errors',
  notes: 'notes',
  dropping: 'dropping',
}

export function findPage(): Page {
  const entries = Object.entries(IDS).map(([key, id]) => [key, document.getElementById(id)])
  return Object.fromEntries(entries) as Page
}
