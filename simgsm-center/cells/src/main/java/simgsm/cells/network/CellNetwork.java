package simgsm.cells.network;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import simgsm.air.CipherAlgorithm;
import simgsm.air.MobileIdentity;
import simgsm.cells.mobile.Mobile;
import simgsm.cells.mobile.MobileEvent;
import simgsm.cells.mobile.MobileNetwork;
import simgsm.cells.mobile.MobilePort;
import simgsm.cells.mobile.Walker;
import simgsm.cells.radio.Propagation;
import simgsm.cells.radio.RadioField;
import simgsm.cells.radio.TowerState;
import simgsm.cells.snapshot.HandoverRule;
import simgsm.cells.snapshot.PassingStep;
import simgsm.cells.tower.AirInterface;
import simgsm.cells.tower.BaseStation;
import simgsm.cells.tower.TowerListener;
import simgsm.cells.tower.TowerRefused;
import simgsm.cells.town.Town;
import simgsm.cells.town.TownPlace;
import simgsm.octets.OctetString;
import simgsm.timer.Timers;

/** The town's towers and mobiles as one deterministic core; a seed makes it repeatable. One owner thread calls all methods. */
public final class CellNetwork implements MobileNetwork, TowerListener {
    private static final int MOST_PASSING = 300;

    private final Town town;
    private final Timers timers = new Timers();
    private final RadioField field;
    private final SplittableRandom random;
    private final List<BaseStation> towers = new ArrayList<>();
    private final Map<BaseStation, Integer> indices = new HashMap<>();
    private final Set<Mobile> mobiles = new LinkedHashSet<>();
    private final Map<String, TownPlace> placed = new HashMap<>();
    private final Deque<PassingStep> passing = new ArrayDeque<>();
    private final Consumer<MobileEvent> listener;
    private Consumer<TowerRefused> onRefusal = refusal -> {};
    private final AirInterface air;
    /** Walks of disconnected terminals, by number; each resumes when its terminal returns. */
    private final Map<String, Walker> walks = new HashMap<>();

    private boolean isPaused;
    private HandoverRule handoverRule = HandoverRule.STANDARD;
    private boolean isServed;

    /** Creates towers that are on, cipher with A5/1, and have no controller yet. */
    public CellNetwork(Town town, long seed, Consumer<MobileEvent> listener) {
        this(town, seed, AirInterface.STANDARD, listener);
    }

    /** As above, with other settings of the air interface. */
    public CellNetwork(Town town, long seed, AirInterface air, Consumer<MobileEvent> listener) {
        this.town = town;
        this.air = air;
        this.listener = listener;
        field = new RadioField(new Propagation(town, seed));
        random = new SplittableRandom(seed);
        town.towers().forEach(tower -> {
            BaseStation station = new BaseStation(tower, town.radioLinkTimeout(), timers, this, air);
            indices.put(station, towers.size());
            towers.add(station);
        });
    }

    /** Sets the receiver of towers' refusals. */
    public void setOnRefusal(Consumer<TowerRefused> receiver) {
        onRefusal = receiver;
    }

    /** The controller's presumed rule, for the window. */
    public HandoverRule handoverRule() {
        return handoverRule;
    }

    public void setHandoverRule(HandoverRule rule) {
        handoverRule = rule;
    }

    // Time.

    public void advance(long nowNanos) {
        timers.advance(nowNanos);
    }

    public OptionalLong nextDeadlineNanos() {
        return timers.nextDeadlineNanos();
    }

    /** The clock and timers of all cores. */
    public Timers timers() {
        return timers;
    }

    public long nowNanos() {
        return timers.nowNanos();
    }

    // Mobiles.

    /** A terminal has connected. */
    public Mobile connected(MobilePort port, String address) {
        Mobile mobile = new Mobile(port, address, this, timers, town.start(address));
        mobiles.add(mobile);
        return mobile;
    }

    /** Removes a disconnected terminal's mobile. */
    public void disconnected(Mobile mobile) {
        if (mobiles.remove(mobile)) {
            mobile.close();
        }
    }

    /** Mobiles in the order of their numbers. */
    public List<Mobile> mobiles() {
        return mobiles.stream().sorted(Comparator.comparing(Mobile::number)).toList();
    }

    public Optional<Mobile> mobile(String number) {
        return mobiles.stream().filter(mobile -> mobile.number().equals(number)).findFirst();
    }

    /** Puts a mobile at a place without a walk, possibly before its appearance. */
    public void place(String number, TownPlace place) {
        placed.put(number, place);
        walks.remove(number);
        mobile(number).ifPresent(mobile -> mobile.walker().standAt(place));
    }

    /** Moves a mobile by hand, and reports it. */
    public void drag(String number, TownPlace place) {
        place(number, place);
        mobile(number).ifPresent(mobile -> happened(new MobileEvent.MobilePlaced(mobile, place)));
    }

    /** Ends a mobile's walk at its current place. */
    public void stand(String number) {
        mobile(number).ifPresent(mobile -> place(number, mobile.walker().place()));
    }

    /**
     * Starts a mobile's walk.
     *
     * @return false if there is no such mobile
     */
    public boolean walk(String number, List<TownPlace> points, double metresPerSecond) {
        Optional<Mobile> mobile = mobile(number);
        mobile.ifPresent(found -> found.walker().walk(points, metresPerSecond));
        return mobile.isPresent();
    }

    /** Pauses or resumes all walks. */
    public void pause(boolean paused) {
        isPaused = paused;
    }

    @Override
    public boolean isPaused() {
        return isPaused;
    }

    /** Places an identified mobile, and starts its walk. */
    @Override
    public void identified(Mobile mobile) {
        String number = mobile.number();
        Walker before = walks.remove(number);
        mobile.walker().standAt(placed.getOrDefault(number, town.start(number)));
        if (before != null) {
            mobile.walker().follow(before);
        } else if (!placed.containsKey(number)) {
            town.walkOf(number).ifPresent(walk -> mobile.walker().walk(walk.points(), walk.metresPerSecond()));
        }
    }

    @Override
    public Set<CipherAlgorithm> algorithms() {
        return air.algorithms();
    }

    // Towers.

    public Town town() {
        return town;
    }

    @Override
    public List<BaseStation> towers() {
        return towers;
    }

    public Optional<BaseStation> tower(String name) {
        return towers.stream()
                .filter(station -> station.tower().name().equals(name))
                .findFirst();
    }

    public void switchTower(BaseStation tower, boolean on) {
        int index = indices.get(tower);
        field.set(index, new TowerState(on, field.tower(index).powerDbm()));
        tower.switchTo(on);
        note(new PassingStep(
                timers.nowNanos(),
                "",
                on ? PassingStep.Kind.TOWER_ON : PassingStep.Kind.TOWER_OFF,
                tower.tower().name(),
                "",
                0));
    }

    public void setPower(BaseStation tower, double dbm) {
        int index = indices.get(tower);
        field.set(index, new TowerState(field.tower(index).isOn(), dbm));
    }

    /** Radiated power now. */
    public double powerDbm(BaseStation tower) {
        return field.tower(indices.get(tower)).powerDbm();
    }

    /** The latest steps, newest last. */
    public Collection<PassingStep> passing() {
        return List.copyOf(passing);
    }

    // Requests of mobiles and towers.

    @Override
    public void levelsDbm(TownPlace place, double[] into) {
        field.levelsDbm(place.xMetres(), place.yMetres(), into);
    }

    @Override
    public double carrierDecibels(int tower, double[] levelsDbm) {
        return field.carrierDecibels(tower, levelsDbm);
    }

    @Override
    public double random() {
        return random.nextDouble();
    }

    @Override
    public void happened(MobileEvent event) {
        PassingSteps.of(event, timers.nowNanos()).ifPresent(this::note);
        listener.accept(event);
    }

    private void note(PassingStep step) {
        passing.add(step);
        if (passing.size() > MOST_PASSING) {
            passing.remove();
        }
    }

    @Override
    public void paged(BaseStation tower, int group, MobileIdentity identity) {
        int index = indices.get(tower);
        int groups = tower.cell().orElseThrow().control().pagingGroups();
        mobiles.forEach(mobile -> mobile.paged(index, group, groups, identity));
    }

    @Override
    public void refused(TowerRefused refusal) {
        note(new PassingStep(timers.nowNanos(), "", PassingStep.Kind.TOWER_REFUSED, refusal.name(), refusal.text(), 0));
        onRefusal.accept(refusal);
    }

    @Override
    public void broadcast(BaseStation tower, OctetString page) {
        int index = indices.get(tower);
        mobiles.forEach(mobile -> mobile.broadcast(index, page));
    }

    /**
     * Disconnects all terminals, which then register again, when the last tower loses its controller and with it the
     * records of the mobiles. A tower switched off is only a gap in the coverage.
     */
    @Override
    public void changed(BaseStation tower) {
        boolean wasServed = isServed;
        isServed = towers.stream().anyMatch(BaseStation::isInService);
        if (wasServed && !isServed && tower.isOn()) {
            mobiles.forEach(mobile -> walks.put(mobile.number(), mobile.walker()));
            List.copyOf(mobiles).forEach(mobile -> mobile.letGo("no tower has a controller"));
        }
    }
}
