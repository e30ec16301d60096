/** As much of a renderer as is called; what it does with the draw is three.js's part and the same for any draw. */
export function idleRenderer() {
  const held = { __webglTexture: true }
  return {
    info: { calls: 0, autoReset: true },
    autoClear: true,
    xr: { enabled: false },
    shadowMap: { autoUpdate: true },
    properties: { get: () => held },
    getRenderTarget: () => null,
    getActiveCubeFace: () => 0,
    getActiveMipmapLevel: () => 0,
    setRenderTarget() {},
    render() {
      this.info.calls++
    },
  }
}
