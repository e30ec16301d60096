/** Creates a stub renderer with the members that `Wrinkles` uses before three.js draws its mesh. */
export function idleRenderer() {
  const properties = { __webglTexture: true }
  return {
    info: { calls: 0, autoReset: true },
    autoClear: true,
    xr: { enabled: false },
    shadowMap: { autoUpdate: true },
    properties: { get: () => properties },
    getContext: () => ({ getExtension: () => ({}) }),
    getRenderTarget: () => null,
    getActiveCubeFace: () => 0,
    getActiveMipmapLevel: () => 0,
    getClearAlpha: () => 0,
    getClearColor() {},
    setClearColor() {},
    setRenderTarget() {},
    clear() {},
    render() {
      this.info.calls++
    },
  }
}
