package simgsm.center.ui;

/** Digits that a table shows in a small monospaced face: identities, times. */
record Digits(String text) {
    @Override
    public String toString() {
        return text;
    }
}
