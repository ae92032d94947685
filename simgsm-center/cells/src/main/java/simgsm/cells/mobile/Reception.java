package simgsm.cells.mobile;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import simgsm.air.MeasurementResults;
import simgsm.cells.radio.RadioScale;
import simgsm.cells.radio.ReceptionQuality;
import simgsm.cells.tower.BaseStation;
import simgsm.cells.town.TownPlace;

/** A mobile's current reception at its place. */
final class Reception {
    /** Level below which a neighbour's BSIC cannot be decoded. */
    private static final double DECODABLE_DBM = -108;

    /** Frequencies of a neighbour list that reports can name (TS 44.018, 10.5.2.20). */
    private static final int REPORTABLE = 32;

    private final MobileNetwork network;
    private final double[] levels;

    Reception(MobileNetwork network) {
        this.network = network;
        levels = new double[network.towers().size()];
    }

    void measure(TownPlace place) {
        network.levelsDbm(place, levels);
    }

    double[] levelsDbm() {
        return levels;
    }

    double errorRate(int tower) {
        return ReceptionQuality.bitErrorRate(network.carrierDecibels(tower, levels));
    }

    int timingAdvance(int tower, TownPlace place) {
        return RadioScale.timingAdvance(
                network.towers().get(tower).tower().place().distanceMetres(place));
    }

    /** The neighbours in a report: at most six of the serving cell's list, strongest first. */
    List<Integer> neighbours(int serving) {
        List<Integer> listed = network.towers().get(serving).neighbours();
        return IntStream.range(0, levels.length)
                .filter(tower -> tower != serving && levels[tower] >= DECODABLE_DBM)
                .filter(tower -> network.towers().get(tower).isInService())
                .filter(tower -> isReportable(
                        listed.indexOf(network.towers().get(tower).tower().arfcn())))
                .boxed()
                .sorted(Comparator.comparingDouble(tower -> -levels[tower]))
                .limit(MeasurementResults.MOST_NEIGHBOURS)
                .toList();
    }

    /** A report has five bits for the place of a frequency in the list. */
    private static boolean isReportable(int place) {
        return place >= 0 && place < REPORTABLE;
    }

    MeasurementResults report(int serving, List<Integer> neighbours) {
        List<Integer> listed = network.towers().get(serving).neighbours();
        List<MeasurementResults.Neighbour> named = new ArrayList<>();
        for (int neighbour : neighbours) {
            BaseStation tower = network.towers().get(neighbour);
            named.add(new MeasurementResults.Neighbour(
                    RadioScale.rxlev(levels[neighbour]),
                    listed.indexOf(tower.tower().arfcn()),
                    tower.tower().bsic()));
        }
        return MeasurementResults.of(RadioScale.rxlev(levels[serving]), RadioScale.rxqual(errorRate(serving)), named);
    }
}
