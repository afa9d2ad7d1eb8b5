self.addEventListener("message", ({ data }) => {
  if (data.step === 13) throw new Error("Thirteen.");
});
