package simgsm.cells.app;

import java.util.function.Consumer;
import simgsm.cells.mobile.MobileEvent;
import simgsm.cells.tower.TowerRefused;
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

    /** Prints a tower's refusal. */
    public void refused(TowerRefused refusal) {
        console.tell(refusal);
    }

    @Override
    public void accept(MobileEvent event) {
        if (!(event instanceof MobileEvent.Reported) || areReportsShown) {
            console.tell(event);
        }
    }
}
