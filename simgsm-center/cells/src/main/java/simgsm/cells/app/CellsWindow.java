package simgsm.cells.app;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import simgsm.cells.net.CellsLoop;
import simgsm.cells.network.TownSnapshots;
import simgsm.cells.radio.Propagation;
import simgsm.cells.snapshot.TownActions;
import simgsm.cells.snapshot.TownSnapshot;
import simgsm.cells.town.TownPlace;
import simgsm.cells.ui.TownWindow;
import simgsm.console.ExitStatus;
import simgsm.console.HostPort;
import simgsm.ui.window.ProgramWindow;

/** The cells with their window: publishes snapshots and performs the user's actions. */
public final class CellsWindow implements TownActions {
    private static final long SNAPSHOT_NANOS = 100_000_000;

    private final CellsLoop cells;
    private final AtomicReference<TownSnapshot> newest = new AtomicReference<>();

    private CellsWindow(CellsLoop cells) {
        this.cells = cells;
    }

    /** Shows the window and returns when it is closed. */
    public static int run(CellsLoop cells, CellsSettings settings, ProgramWindow window) throws InterruptedException {
        CellsWindow actions = new CellsWindow(cells);
        InetSocketAddress controller = settings.controllerAddress();
        TownSnapshots snapshots = new TownSnapshots(
                cells.port(),
                new HostPort(controller.getHostString(), controller.getPort()).toString(),
                settings.isOsmocom());
        actions.newest.set(cells.ask(snapshots::of));
        cells.observe(SNAPSHOT_NANOS, network -> actions.newest.set(snapshots.of(network)));
        window.show(
                language -> TownWindow.content(actions, new Propagation(settings.town(), settings.seed()), language));
        return ExitStatus.OK;
    }

    @Override
    public TownSnapshot snapshot() {
        return newest.get();
    }

    @Override
    public void place(String number, TownPlace place) {
        cells.post(network -> network.drag(number, place));
    }

    @Override
    public void stand(String number) {
        cells.post(network -> network.stand(number));
    }

    @Override
    public void walk(String number, List<TownPlace> points, double metresPerSecond) {
        cells.post(network -> network.walk(number, points, metresPerSecond));
    }

    @Override
    public void switchTower(String tower, boolean on) {
        cells.post(network -> network.tower(tower).ifPresent(found -> cells.switchTower(found, on)));
    }

    @Override
    public void setPower(String tower, double dbm) {
        cells.post(network -> network.tower(tower).ifPresent(found -> network.setPower(found, dbm)));
    }

    @Override
    public void pause(boolean paused) {
        cells.post(network -> network.pause(paused));
    }
}
