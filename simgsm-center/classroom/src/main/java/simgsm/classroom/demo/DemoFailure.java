package simgsm.classroom.demo;

/** A failed step of the demo; the text names the program and what was expected. */
final class DemoFailure extends Exception {
    DemoFailure(String text) {
        super(text);
    }
}
