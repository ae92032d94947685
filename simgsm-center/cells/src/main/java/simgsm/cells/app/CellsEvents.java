package simgsm.cells.app;

import java.util.function.Consumer;
import simgsm.cells.mobile.MobileEvent;
import simgsm.console.Console;

/** Prints the mobiles' events on the console; reports only on request. */
public final class CellsEvents implements Consumer<MobileEvent> {
    private final Console console;
    private volatile boolean areReportsShown;

    public CellsEvents(Console console) {
        this.console = console;
    }

    void showReports(boolean shown) {
        areReportsShown = shown;
    }

    @Override
    public void accept(MobileEvent event) {
        if (!(event instanceof MobileEvent.Reported) || areReportsShown) {
            console.tell(event);
        }
    }
}
