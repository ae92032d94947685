package simgsm.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.junit.jupiter.api.Test;

class StateTableTest {
    private enum Lamp {
        OFF,
        ON,
        BROKEN
    }

    private enum Act {
        PRESS,
        KICK,
        LOOK
    }

    private enum Deed {
        CLICK,
        BANG
    }

    private static StateTable<Lamp, Act, Deed> table() {
        return new StateTable<Lamp, Act, Deed>("lamp", Lamp.OFF)
                .on(Lamp.OFF, Act.PRESS, Lamp.ON, Deed.CLICK)
                .on(Lamp.ON, Act.PRESS, Lamp.OFF, Deed.CLICK)
                .on(EnumSet.of(Lamp.OFF, Lamp.ON), Act.KICK, Lamp.BROKEN, Deed.BANG, Deed.CLICK)
                .stay(EnumSet.of(Lamp.ON), Act.LOOK);
    }

    @Test
    void aSecondRowForAStateAndAnEventIsRefused() {
        IllegalArgumentException twice =
                assertThrows(IllegalArgumentException.class, () -> table().on(Lamp.ON, Act.KICK, Lamp.ON));
        assertEquals("lamp: two rows for KICK in ON", twice.getMessage());
        assertThrows(IllegalArgumentException.class, () -> table().stay(Set.of(Lamp.ON), Act.LOOK));
    }

    @Test
    void aRowIsAddedForEachPairOfAStateAndAnEvent() {
        StateTable<Lamp, Act, Deed> table = new StateTable<Lamp, Act, Deed>("lamp", Lamp.OFF)
                .on(EnumSet.of(Lamp.OFF, Lamp.ON), EnumSet.of(Act.KICK, Act.PRESS), Lamp.BROKEN, Deed.BANG);
        assertEquals(4, table.rows().size());
        assertEquals(
                new StateTable.Row<>(Lamp.ON, Act.KICK, Lamp.BROKEN, List.of(Deed.BANG)),
                table.row(Lamp.ON, Act.KICK).orElseThrow());
    }

    @Test
    void aMachineCanBeginInAnotherStateThanTheInitialOne() {
        assertEquals(Lamp.ON, new StateMachine<>(table(), "desk", deed -> {}, Lamp.ON).state());
    }

    @Test
    void aMachinePerformsTheActionsOfARowInOrderAfterTheStateHasChanged() {
        List<String> done = new ArrayList<>();
        List<StateMachine<Lamp, Act, Deed>> self = new ArrayList<>();
        StateMachine<Lamp, Act, Deed> machine = new StateMachine<>(
                table(), "desk", deed -> done.add(deed + " in " + self.get(0).state()));
        self.add(machine);
        assertEquals(Lamp.OFF, machine.state());
        assertTrue(machine.fire(Act.PRESS));
        assertTrue(machine.fire(Act.LOOK));
        assertTrue(machine.fire(Act.KICK));
        assertEquals(List.of("CLICK in ON", "BANG in BROKEN", "CLICK in BROKEN"), done);
    }

    @Test
    void anEventWithoutARowChangesNothing() {
        List<Deed> done = new ArrayList<>();
        StateMachine<Lamp, Act, Deed> machine = new StateMachine<>(table(), "desk", done::add);
        assertFalse(machine.accepts(Act.LOOK));
        assertFalse(machine.fire(Act.LOOK));
        assertEquals(Lamp.OFF, machine.state());
        assertEquals(List.of(), done);
    }

    @Test
    void theDiagramHasTheTextsOfStatesAndEventsWhereTheyAreGiven() {
        String uml = table().texts(lamp -> lamp.name().toLowerCase(Locale.ROOT), act -> "button " + act.ordinal())
                .plantUml();
        assertTrue(uml.contains("state \"on\" as ON\n"), uml);
        assertTrue(uml.contains("OFF --> ON : button 0\n"), uml);
    }

    @Test
    void theDiagramHasAnArrowForEachPairOfStates() {
        assertEquals("""
                @startuml
                !include look.iuml
                title lamp
                hide empty description
                state "OFF" as OFF
                state "ON" as ON
                state "BROKEN" as BROKEN
                [*] --> OFF
                OFF --> ON : PRESS
                ON --> OFF : PRESS
                OFF --> BROKEN : KICK
                ON --> BROKEN : KICK
                @enduml
                """, table().plantUml());
    }
}
