package simgsm.cells.net;

import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import simgsm.cells.tower.BaseStation;
import simgsm.net.Connection;
import simgsm.net.Connector;
import simgsm.net.LineAddress;
import simgsm.net.SelectorLoop;

/** Keeps one tower connected to the controller while it is on. */
final class TowerLink implements Connector.Listener {
    private static final System.Logger LOG = System.getLogger(TowerLink.class.getName());

    private final CellsLoop cells;
    private final SelectorLoop loop;
    private final BaseStation tower;
    private final InetSocketAddress controller;
    private Connector connector;
    private boolean isAbsenceLogged;

    TowerLink(CellsLoop cells, SelectorLoop loop, BaseStation tower, InetSocketAddress controller) {
        this.cells = cells;
        this.loop = loop;
        this.tower = tower;
        this.controller = controller;
        connect();
    }

    boolean isOf(BaseStation other) {
        return tower == other;
    }

    private void connect() {
        connector = new Connector(loop, controller, this);
        connector.start();
    }

    void switchTo(boolean on) {
        if (on && connector == null) {
            connect();
        } else if (!on && connector != null) {
            connector.close();
            connector = null;
        }
    }

    @Override
    public Connection connected(Connection.Endpoint endpoint) {
        return new TowerConnection(endpoint, cells, tower, this::lost);
    }

    /** Handles a connection's end; the tower has logged a refusal. */
    private void lost(String reason, boolean wasInService) {
        isAbsenceLogged &= !wasInService;
        if (tower.refusal().isEmpty()) {
            logAbsence(reason);
        }
    }

    @Override
    public void failed(String reason) {
        tower.forgetRefusal();
        logAbsence(reason);
    }

    private void logAbsence(String reason) {
        if (!isAbsenceLogged) {
            isAbsenceLogged = true;
            LOG.log(
                    Level.WARNING,
                    "{0}: no controller at {1} ({2}); trying again",
                    tower,
                    LineAddress.of(controller),
                    reason);
        }
    }
}
