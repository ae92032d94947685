package simgsm.classroom.demo;

import java.util.Optional;
import simgsm.center.app.ChildConsole;
import simgsm.console.Event;

/** Waits for a child's event {@code lesson name=}: its user begins a lesson in the help of its window. */
final class LessonChoice implements ChildConsole.Listener {
    private Runnable whenChosen = () -> {};
    private String chosen;

    /** Sets what is done at a choice; at once if there was one. */
    synchronized void onChosen(Runnable action) {
        whenChosen = action;
        if (chosen != null) {
            action.run();
        }
    }

    void listenTo(Process child) {
        new ChildConsole("child", child, this);
    }

    synchronized Optional<String> chosen() {
        return Optional.ofNullable(chosen);
    }

    @Override
    public void line(String line) {}

    @Override
    public synchronized void event(Event event) {
        if (event.name().equals("lesson") && event.fields().containsKey("name")) {
            chosen = event.fields().get("name");
            whenChosen.run();
        }
    }

    @Override
    public void ended() {}
}
