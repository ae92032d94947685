package blackbox.face;

import blackbox.Scenario;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import simgsm.cells.radio.Propagation;
import simgsm.cells.snapshot.CellState;
import simgsm.cells.snapshot.MobileState;
import simgsm.cells.snapshot.MobileState.Level;
import simgsm.cells.snapshot.PassingStep;
import simgsm.cells.snapshot.TownActions;
import simgsm.cells.snapshot.TownSnapshot;
import simgsm.cells.town.Tower;
import simgsm.cells.town.Town;
import simgsm.cells.town.TownFile;

/** The city with a phone in a call, an idle robot and one mobile without a cell, after a handover. */
final class TownScene {
    private final Town town;
    private final TownSnapshot snapshot;

    TownScene() {
        try {
            town = TownFile.read(Scenario.world("city.town"));
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
        List<Tower> towers = town.towers();
        List<CellState> cells = towers.stream()
                .map(tower -> new CellState(tower.name(), tower.area(), tower != towers.get(0), true, "", 40, 5, 6))
                .toList();
        List<Level> heard = new ArrayList<>();
        towers.stream()
                .limit(7)
                .forEach(tower -> heard.add(new Level(
                        tower.name(), -71 - 5 * heard.size(), OptionalDouble.of(-73), OptionalDouble.empty())));
        List<Level> idle = heard.stream()
                .map(level -> new Level(
                        level.cell(), level.dbm(), OptionalDouble.empty(), OptionalDouble.of(level.dbm() + 104)))
                .toList();
        List<MobileState> mobiles = List.of(
                mobile("5550100", MobileState.State.DEDICATED, heard),
                mobile("5550200", MobileState.State.IDLE, idle),
                mobile("5550201", MobileState.State.SEARCHING, List.of()));
        List<PassingStep> passing = new ArrayList<>();
        for (PassingStep.Kind kind : PassingStep.Kind.values()) {
            passing.add(new PassingStep(
                    0, "5550100", kind, towers.get(0).name(), towers.get(1).name(), 17));
        }
        snapshot = new TownSnapshot(
                0,
                town,
                3013,
                "127.0.0.1:3003",
                false,
                TownSnapshot.ControllerLink.PARTLY,
                false,
                cells,
                mobiles,
                passing);
    }

    private MobileState mobile(String number, MobileState.State state, List<Level> heard) {
        boolean isInCall = state == MobileState.State.DEDICATED;
        return new MobileState(
                number,
                town.start(number),
                heard.isEmpty() ? "" : heard.get(0).cell(),
                state,
                isInCall,
                false,
                List.of(),
                heard,
                isInCall ? OptionalInt.of(3) : OptionalInt.empty(),
                isInCall ? OptionalInt.of(2) : OptionalInt.empty(),
                isInCall ? OptionalInt.of(16) : OptionalInt.empty(),
                isInCall ? OptionalInt.of(2) : OptionalInt.empty(),
                3,
                3,
                isInCall ? OptionalInt.of(60) : OptionalInt.empty());
    }

    TownActions actions() {
        return IdleProgram.behind(TownActions.class, Map.of("snapshot", snapshot));
    }

    Propagation propagation() {
        return new Propagation(town, 1);
    }
}
