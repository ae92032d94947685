package simgsm.cells.snapshot;

import java.util.List;
import simgsm.cells.town.TownPlace;

/** What the window asks of the program. Any thread may call; the owner thread acts. */
public interface TownActions {
    /** The newest snapshot; null before the first. */
    TownSnapshot snapshot();

    /** Puts a mobile at a place by hand; it stays there. */
    void place(String number, TownPlace place);

    /** Ends a mobile's walk. */
    void stand(String number);

    /** Lets a mobile walk along points, to and fro if there is more than one. */
    void walk(String number, List<TownPlace> points, double metresPerSecond);

    void switchTower(String tower, boolean on);

    void setPower(String tower, double dbm);

    /** Lets all walking mobiles stand still, or go on. */
    void pause(boolean paused);
}
