package simgsm.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.air.Msisdn;
import simgsm.sim.PinLock.Result;
import simgsm.sim.PinLock.State;

class PinLockTest {
    private static final String PIN = "1234";
    private static final String PUK = "12345678";

    private final List<CardPin> kept = new ArrayList<>();
    private final PinLock lock = lock(new CardPin(PIN, PUK, true, 3, 10));

    private PinLock lock(CardPin pin) {
        return new PinLock(Optional.of(pin), kept::add);
    }

    private static void is(PinLock lock, State state, int tries) {
        assertEquals(state, lock.status().state());
        assertEquals(tries, lock.status().tries());
    }

    @Test
    void theRightPinOpensUntilTheNextPowerOn() {
        is(lock, State.PIN, 3);
        assertEquals(Result.DONE, lock.verify(PIN));
        is(lock, State.READY, 3);
        lock.reset();
        is(lock, State.PIN, 3);
    }

    @Test
    void threeWrongPinsAskForThePukAndTheRightPinIsNoLongerTaken() {
        assertEquals(Result.WRONG, lock.verify("0000"));
        assertEquals(Result.DONE, lock.verify(PIN));
        is(lock, State.READY, 3);
        for (int left = 2; left >= 0; left--) {
            assertEquals(Result.WRONG, lock.verify("0000"));
            assertEquals(left, kept.get(kept.size() - 1).tries());
        }
        is(lock, State.PUK, 10);
        assertEquals(Result.REFUSED, lock.verify(PIN));
        assertEquals(Result.DONE, lock.unblock(PUK, "4321"));
        is(lock, State.READY, 3);
        lock.reset();
        assertEquals(Result.DONE, lock.verify("4321"));
    }

    @Test
    void tenWrongPuksBlockTheCardForEver() {
        for (int tries = 0; tries < 10; tries++) {
            assertEquals(Result.WRONG, lock.unblock("00000000", PIN));
        }
        PinLock restarted = lock(kept.get(kept.size() - 1).withTries(0, 0));
        is(restarted, State.BLOCKED, 0);
        assertEquals(Result.REFUSED, restarted.unblock(PUK, PIN));
        assertEquals(Result.REFUSED, restarted.verify(PIN));
    }

    @Test
    void aRestartGivesNoNewTries() {
        lock.verify("0000");
        lock.verify("0000");
        is(lock(kept.get(1)), State.PIN, 1);
    }

    @Test
    void aPinThatIsSwitchedOffIsNotAskedForAndCannotBeChanged() {
        assertEquals(Result.WRONG, lock.enable(false, "0000"));
        assertEquals(Result.DONE, lock.enable(false, PIN));
        lock.reset();
        is(lock, State.READY, 3);
        assertEquals(Result.REFUSED, lock.change(PIN, "4321"));
        assertEquals(Result.REFUSED, lock.verify(PIN));
        assertEquals(Result.DONE, lock.enable(true, PIN));
        lock.reset();
        is(lock, State.PIN, 3);
    }

    @Test
    void typedCodesAreThoseOfTheStandard() {
        assertTrue(PinLock.isCode("**04*1234*4321*4321#"));
        assertEquals(Result.DONE, lock.perform("**04*1234*4321*4321#"));
        assertEquals(Result.REFUSED, lock.perform("**04*4321*1111*2222#"), "the new ones differ");
        assertEquals(Result.WRONG, lock.perform("**04*0000*1111*1111#"));
        assertEquals(Result.WRONG, lock.perform("**05*00000000*1111*1111#"));
        assertEquals(Result.DONE, lock.perform("**05*12345678*1111*1111#"));
        assertEquals(Result.REFUSED, lock.perform("**042*1111*2222*2222#"), "the card has no second PIN");
        assertEquals(Result.DONE, lock.change("1111", PIN));
    }

    @Test
    void aCardWithoutAPinIsReady() {
        is(PinLock.none(), State.READY, 3);
        assertEquals(Result.REFUSED, PinLock.none().verify(PIN));
        assertEquals(Result.REFUSED, PinLock.none().unblock(PUK, PIN));
    }

    @Test
    void theFileKeepsTriesAndChangesAndAllOtherLines(@TempDir Path folder) throws IOException {
        String keys = " imsi=00101000555010%d k=465b5ce8b199b49faa5f0a2ee238a6bc algorithm=comp128v1";
        Path file = folder.resolve("two.sim");
        Files.writeString(
                file,
                "# ours\nsim number=5550100" + keys.formatted(0) + " pin=1234 puk=12345678 # Ana\nsim pin=1111"
                        + " puk=11111111 number=5550101" + keys.formatted(1) + "\n");
        InsertedCard card = SimSlot.of(Optional.of(file))
                .card(Optional.of(new Msisdn("5550100")))
                .orElseThrow();
        card.lock().verify("0000");
        assertEquals(
                "# ours\nsim number=5550100" + keys.formatted(0)
                        + " pin=1234 puk=12345678 pin-enabled=true pin-tries=2 puk-tries=10 # Ana\nsim pin=1111"
                        + " puk=11111111 number=5550101" + keys.formatted(1) + "\n",
                Files.readString(file));
        is(
                SimSlot.of(Optional.of(file))
                        .card(Optional.of(new Msisdn("5550100")))
                        .orElseThrow()
                        .lock(),
                State.PIN,
                2);
    }
}
