package simgsm.modem.client;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.function.Consumer;
import simgsm.modem.ModemEvent;
import simgsm.modem.ModemState;
import simgsm.station.context.StationEvent;

/** The state of an attached modem; each change is logged and reported, a new text alone is only stored. */
final class ReportedState {
    private static final Logger LOG = System.getLogger(ReportedState.class.getName());
    private static final ModemEvent.StateChanged NOT_ASKED =
            new ModemEvent.StateChanged(ModemState.SILENT, "the line is not open yet");

    private final String modem;
    private final Consumer<StationEvent> listener;
    private volatile ModemEvent.StateChanged newest = NOT_ASKED;
    private String text = "";
    private String soundObstacle = "";

    /** @param modem name for the log */
    ReportedState(String modem, Consumer<StationEvent> listener) {
        this.modem = modem;
        this.listener = listener;
    }

    /** Callable on any thread. */
    ModemEvent.StateChanged newest() {
        return newest;
    }

    /** A ready modem is reported again. @param obstacle of its sound, told with READY; empty for none */
    void soundChanged(String obstacle) {
        soundObstacle = obstacle.isEmpty() ? "" : "; no sound: " + obstacle;
        if (newest.state() == ModemState.READY) {
            newest = new ModemEvent.StateChanged(ModemState.READY, text + soundObstacle);
            listener.accept(newest);
        }
    }

    /** @param isLogged true if the log already has a warning of the line */
    void set(ModemState now, String newText, boolean isLogged) {
        boolean isNews = newest == NOT_ASKED || newest.state() != now;
        text = newText;
        newest = new ModemEvent.StateChanged(now, now == ModemState.READY ? text + soundObstacle : text);
        if (isNews) {
            Level level = isLogged || now == ModemState.READY ? Level.INFO : Level.WARNING;
            LOG.log(level, modem + ": " + now.word() + ", " + text);
            listener.accept(newest);
        }
    }
}
