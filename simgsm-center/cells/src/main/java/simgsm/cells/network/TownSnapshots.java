package simgsm.cells.network;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import simgsm.cells.mobile.IdleSelection;
import simgsm.cells.mobile.Mobile;
import simgsm.cells.mobile.MobileRadioTable.MobileRadioState;
import simgsm.cells.radio.RadioField;
import simgsm.cells.radio.RadioScale;
import simgsm.cells.snapshot.CellState;
import simgsm.cells.snapshot.HandoverRule;
import simgsm.cells.snapshot.MobileState;
import simgsm.cells.snapshot.TownSnapshot;
import simgsm.cells.snapshot.TownSnapshot.ControllerLink;
import simgsm.cells.tower.BaseStation;

/** Makes the window's snapshots. */
public final class TownSnapshots {
    /** Number of a mobile's cells besides the serving one. */
    private static final int NEIGHBOURS = 6;

    private final int port;
    private final String controller;
    private final boolean isOsmocom;

    public TownSnapshots(int port, String controller, boolean isOsmocom) {
        this.port = port;
        this.controller = controller;
        this.isOsmocom = isOsmocom;
    }

    public TownSnapshot of(CellNetwork network) {
        return new TownSnapshot(
                network.nowNanos(),
                network.town(),
                port,
                controller,
                isOsmocom,
                link(network.towers()),
                network.isPaused(),
                network.towers().stream().map(tower -> cell(network, tower)).toList(),
                network.mobiles().stream()
                        .map(mobile -> mobile(network, mobile))
                        .toList(),
                List.copyOf(network.passing()));
    }

    private static ControllerLink link(List<BaseStation> towers) {
        long on = towers.stream().filter(BaseStation::isOn).count();
        long connected = towers.stream().filter(BaseStation::isInService).count();
        return connected == 0 ? ControllerLink.SEARCHING : connected < on ? ControllerLink.PARTLY : ControllerLink.UP;
    }

    private static CellState cell(CellNetwork network, BaseStation tower) {
        return new CellState(
                tower.tower().name(),
                tower.area(),
                tower.isOn(),
                tower.isInService(),
                tower.refusal(),
                network.powerDbm(tower),
                tower.freeTrafficChannels(),
                tower.tower().trafficChannels());
    }

    private static MobileState mobile(CellNetwork network, Mobile mobile) {
        HandoverRule rule = network.handoverRule();
        boolean isConnected = mobile.channel().isPresent();
        int serving = mobile.serving();
        double[] levels = mobile.levelsDbm();
        return new MobileState(
                mobile.number(),
                mobile.walker().place(),
                mobile.cell(),
                state(mobile),
                mobile.channel().filter(channel -> channel.isTraffic()).isPresent(),
                mobile.channel().filter(channel -> channel.isCiphered()).isPresent(),
                mobile.walker().ahead(),
                levels(network, mobile, levels),
                isConnected ? OptionalInt.of(mobile.link().quality()) : OptionalInt.empty(),
                isConnected
                        ? OptionalInt.of(RadioScale.timingAdvance(network.towers()
                                .get(serving)
                                .tower()
                                .place()
                                .distanceMetres(mobile.walker().place())))
                        : OptionalInt.empty(),
                isConnected ? OptionalInt.of(mobile.link().count()) : OptionalInt.empty(),
                isConnected
                        ? OptionalInt.of(rule.periodReports() - mobile.link().reports() % rule.periodReports())
                        : OptionalInt.empty(),
                rule.periodReports(),
                isConnected ? rule.marginDecibels() : hysteresis(network, serving),
                mobile.gapMillis());
    }

    private static double hysteresis(CellNetwork network, int serving) {
        return serving == IdleSelection.NONE
                ? 0
                : network.towers()
                        .get(serving)
                        .cell()
                        .map(cell -> cell.selection().hysteresisDecibels())
                        .orElse(0);
    }

    private static MobileState.State state(Mobile mobile) {
        if (mobile.state() == MobileRadioState.HANDOVER) {
            return MobileState.State.HANDOVER;
        }
        if (mobile.channel().isPresent()) {
            return MobileState.State.DEDICATED;
        }
        return mobile.serving() == IdleSelection.NONE ? MobileState.State.SEARCHING : MobileState.State.IDLE;
    }

    private static List<MobileState.Level> levels(CellNetwork network, Mobile mobile, double[] levels) {
        int serving = mobile.serving();
        int averaged = network.handoverRule().averagedReports();
        boolean isConnected = mobile.channel().isPresent();
        List<Integer> order = new ArrayList<>();
        if (serving != IdleSelection.NONE) {
            order.add(serving);
        }
        IntStream.range(0, levels.length)
                .filter(tower -> tower != serving && levels[tower] > RadioField.SILENCE_DBM)
                .boxed()
                .sorted(Comparator.comparingDouble(tower -> -levels[tower]))
                .limit(NEIGHBOURS)
                .forEach(order::add);
        return order.stream()
                .map(tower -> new MobileState.Level(
                        network.towers().get(tower).tower().name(),
                        levels[tower],
                        isConnected && mobile.link().recent().has(averaged)
                                ? OptionalDouble.of(mobile.link().recent().averageDbm(tower, averaged))
                                : OptionalDouble.empty(),
                        isConnected || Double.isInfinite(mobile.selection().c2(tower))
                                ? OptionalDouble.empty()
                                : OptionalDouble.of(mobile.selection().c2(tower))))
                .toList();
    }
}
