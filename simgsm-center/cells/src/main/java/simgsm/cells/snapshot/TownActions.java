package simgsm.cells.snapshot;

import java.util.List;
import simgsm.cells.town.TownPlace;

/** The window's requests to the program. Callable on any thread; performed by the owner thread. */
public interface TownActions {
    /** The newest snapshot; null before the first. */
    TownSnapshot snapshot();

    /** Moves a mobile by hand and ends its walk. */
    void place(String number, TownPlace place);

    /** Ends a mobile's walk. */
    void stand(String number);

    /** Starts a mobile's walk along points, to and fro if there is more than one. */
    void walk(String number, List<TownPlace> points, double metresPerSecond);

    void switchTower(String tower, boolean on);

    void setPower(String tower, double dbm);

    /** Pauses or resumes all walks. */
    void pause(boolean paused);
}
