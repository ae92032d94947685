package simgsm.cells.ui;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.stream.IntStream;
import simgsm.cells.radio.Propagation;
import simgsm.cells.radio.RadioField;
import simgsm.cells.radio.RadioScale;
import simgsm.cells.radio.ReceptionQuality;
import simgsm.cells.radio.TowerState;
import simgsm.cells.snapshot.CellState;
import simgsm.cells.snapshot.MobileState;
import simgsm.cells.snapshot.MobileState.Level;
import simgsm.cells.snapshot.PassingStep;
import simgsm.cells.snapshot.TownActions;
import simgsm.cells.snapshot.TownSnapshot;
import simgsm.cells.town.Town;
import simgsm.cells.town.TownFile;
import simgsm.cells.town.TownPlace;

/** A town without a core: its mobiles are where actions put them and are served by the strongest tower. */
final class SampleTown implements TownActions {
    static final String PHONE = "5550100";
    static final String ROBOT = "5550200";

    final List<String> acts = new ArrayList<>();
    final List<PassingStep> passing = new ArrayList<>();
    final Town town;
    final Propagation propagation;
    private final RadioField field;
    private final Map<String, TownPlace> places = new LinkedHashMap<>();
    private final Map<String, List<TownPlace>> paths = new LinkedHashMap<>();
    private boolean isPaused;
    long nanos;

    SampleTown(String name) throws IOException {
        town = TownFile.read(Path.of("../../worlds", name + ".town"));
        propagation = new Propagation(town, 1);
        field = new RadioField(propagation);
        places.put(PHONE, town.start(PHONE));
        places.put(ROBOT, town.start(ROBOT));
    }

    void pass(PassingStep.Kind kind, int figure) {
        String first = town.towers().get(0).name();
        String second = town.towers().get(1).name();
        passing.add(new PassingStep(nanos, PHONE, kind, first, second, figure));
    }

    void removeMobiles() {
        places.clear();
    }

    @Override
    public TownSnapshot snapshot() {
        List<CellState> cells = IntStream.range(0, town.towers().size())
                .mapToObj(i -> new CellState(
                        town.towers().get(i).name(),
                        town.towers().get(i).area(),
                        field.tower(i).isOn(),
                        true,
                        "",
                        field.tower(i).powerDbm(),
                        5,
                        6))
                .toList();
        List<MobileState> mobiles = places.keySet().stream().map(this::mobile).toList();
        return new TownSnapshot(
                nanos,
                town,
                3013,
                "127.0.0.1:3003",
                false,
                TownSnapshot.ControllerLink.UP,
                isPaused,
                cells,
                mobiles,
                passing);
    }

    private MobileState mobile(String number) {
        TownPlace place = places.get(number);
        boolean isInCall = number.equals(PHONE);
        double[] levels = new double[town.towers().size()];
        field.levelsDbm(place.xMetres(), place.yMetres(), levels);
        List<Integer> order = IntStream.range(0, levels.length)
                .boxed()
                .filter(i -> levels[i] > -115)
                .sorted(Comparator.comparing((Integer i) -> -levels[i]))
                .limit(7)
                .toList();
        List<Level> heard = order.stream()
                .map(i -> new Level(
                        town.towers().get(i).name(),
                        levels[i],
                        isInCall ? OptionalDouble.of(levels[i] - 2) : OptionalDouble.empty(),
                        isInCall ? OptionalDouble.empty() : OptionalDouble.of(levels[i] + 105)))
                .toList();
        int serving = order.isEmpty() ? -1 : order.get(0);
        if (serving < 0) {
            return new MobileState(
                    number,
                    place,
                    "",
                    MobileState.State.SEARCHING,
                    false,
                    false,
                    List.of(),
                    List.of(),
                    OptionalInt.empty(),
                    OptionalInt.empty(),
                    OptionalInt.empty(),
                    OptionalInt.empty(),
                    6,
                    3,
                    OptionalInt.empty());
        }
        double errors = ReceptionQuality.bitErrorRate(field.carrierDecibels(serving, levels));
        return new MobileState(
                number,
                place,
                heard.get(0).cell(),
                isInCall ? MobileState.State.DEDICATED : MobileState.State.IDLE,
                isInCall,
                isInCall,
                paths.getOrDefault(number, List.of()),
                heard,
                isInCall ? OptionalInt.of(RadioScale.rxqual(errors)) : OptionalInt.empty(),
                isInCall
                        ? OptionalInt.of(RadioScale.timingAdvance(
                                propagation.distanceMetres(serving, place.xMetres(), place.yMetres())))
                        : OptionalInt.empty(),
                isInCall ? OptionalInt.of(16) : OptionalInt.empty(),
                isInCall ? OptionalInt.of(2) : OptionalInt.empty(),
                6,
                3,
                isInCall ? OptionalInt.of(60) : OptionalInt.empty());
    }

    @Override
    public void place(String number, TownPlace place) {
        acts.add("place %s %.0f %.0f".formatted(number, place.xMetres(), place.yMetres()));
        places.put(number, place);
        paths.remove(number);
    }

    @Override
    public void stand(String number) {
        acts.add("stand " + number);
        paths.remove(number);
    }

    /** A mobile that comes after the others, in the order of their numbers. */
    void connect(String number) {
        places.put(number, town.start(number));
        Map<String, TownPlace> sorted = new TreeMap<>(places);
        places.clear();
        places.putAll(sorted);
    }

    @Override
    public void walk(String number, List<TownPlace> points, double metresPerSecond) {
        acts.add("walk " + number + " " + points.size() + " at " + metresPerSecond);
        paths.put(number, points);
    }

    @Override
    public void switchTower(String tower, boolean on) {
        acts.add(tower + (on ? " on" : " off"));
        set(tower, new TowerState(on, field.tower(indexOf(tower)).powerDbm()));
    }

    @Override
    public void setPower(String tower, double dbm) {
        acts.add(tower + " " + dbm);
        set(tower, new TowerState(field.tower(indexOf(tower)).isOn(), dbm));
    }

    private void set(String tower, TowerState state) {
        field.set(indexOf(tower), state);
    }

    private int indexOf(String tower) {
        return town.towers().indexOf(town.tower(tower).orElseThrow());
    }

    @Override
    public void pause(boolean paused) {
        acts.add(paused ? "pause" : "go on");
        isPaused = paused;
    }
}
