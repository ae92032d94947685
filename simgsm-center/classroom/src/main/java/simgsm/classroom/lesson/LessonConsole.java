package simgsm.classroom.lesson;

import simgsm.center.app.ChildConsole;
import simgsm.console.Event;

/** What a program of a lesson prints: for the conditions, and what a student has to know without having waited for it. */
abstract class LessonConsole implements ChildConsole.Listener {
    /** Called by the thread of the program's console. */
    interface Troubles {
        /** A program has refused a line of this action. */
        void refused(String action, String why);

        /** A program has ended; {@code isFault}: before it was ready, or with an exit status other than 0. */
        void ended(String program, int status, boolean isFault);

        /** The robot has hung up, because no key came for these seconds. */
        void idle(String seconds);
    }

    /** For a lesson without a window. */
    static final Troubles NONE = new Troubles() {
        @Override
        public void refused(String action, String why) {}

        @Override
        public void ended(String program, int status, boolean isFault) {}

        @Override
        public void idle(String seconds) {}
    };

    private final String name;
    private final Process process;
    private final LessonEvents events;
    private boolean isReady;

    LessonConsole(String name, Process process, LessonEvents events) {
        this.name = name;
        this.process = process;
        this.events = events;
    }

    /** The latest action; empty before the first one. */
    abstract String action();

    abstract Troubles troubles();

    /** The program is ready with an AT port. */
    abstract void atPort(int port);

    @Override
    public void line(String line) {}

    @Override
    public void event(Event event) {
        if (event.name().equals("ready")) {
            isReady = true;
            String ports = event.fields().getOrDefault("at", "");
            if (!ports.isEmpty()) {
                atPort(Integer.parseInt(ports.split(",")[0]));
            }
        }
        events.add(name, event);
        if (event.name().equals("error") && !action().isEmpty()) {
            troubles().refused(action(), event.fields().getOrDefault("text", ""));
        } else if (event.name().equals("call-idle")) {
            troubles().idle(event.fields().getOrDefault("seconds", ""));
        }
    }

    @Override
    public void ended() {
        events.ended(name);
        try {
            int status = process.waitFor();
            troubles().ended(name, status, !isReady || status != 0);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
