package simgsm.phone.handset;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.Msisdn;
import simgsm.station.context.StationEvent;
import simgsm.station.context.UssdEnding;

class UserCodesTest {
    private static final StationEvent REGISTERED = new StationEvent.StationRegistered(new Msisdn("5550100"));
    private static final StationEvent ANSWER = new StationEvent.UssdReceived("ok", false);
    private static final String RESULT = "*301*tones*low*pass*1*0#";

    private final List<String> sent = new ArrayList<>();
    private boolean isBusy;
    private final UserCodes codes = new UserCodes(code -> !isBusy && sent.add(code));

    private void result() {
        codes.result("tones", "low", "pass", "1", "0");
    }

    private static StationEvent ended(UssdEnding how) {
        return new StationEvent.UssdEnded(how, Optional.empty());
    }

    private void expectSent(String... expected) {
        assertEquals(List.of(expected), sent);
        sent.clear();
    }

    @Test
    void aNameWaitsForTheRegistrationAndIsToldAtEachOne() {
        codes.name("Eva");
        codes.name("Ana");
        expectSent();
        codes.accept(REGISTERED);
        expectSent("*300*Ana#");
        codes.accept(ANSWER);
        codes.accept(REGISTERED);
        expectSent("*300*Ana#");
    }

    @Test
    void resultsAreToldOneAfterTheOther() {
        codes.accept(REGISTERED);
        result();
        codes.result("tones", "high", "fail", "2", "1");
        expectSent(RESULT);
        codes.accept(ANSWER);
        expectSent("*301*tones*high*fail*2*1#");
        codes.accept(ANSWER);
        codes.accept(ANSWER);
        expectSent();
    }

    @Test
    void aResultWithoutServiceIsToldAtTheNextRegistration() {
        codes.accept(REGISTERED);
        result();
        expectSent(RESULT);
        codes.accept(ended(UssdEnding.NO_SERVICE));
        expectSent();
        codes.accept(new StationEvent.StationUnregistered(Optional.empty()));
        codes.accept(REGISTERED);
        expectSent(RESULT);
    }

    @Test
    void aNetworkThatRefusesAResultIsNotAskedAgain() {
        codes.accept(REGISTERED);
        result();
        expectSent(RESULT);
        codes.accept(ended(UssdEnding.REFUSED));
        codes.accept(REGISTERED);
        expectSent();
    }

    @Test
    void aResultWaitsForTheEndOfTheUsersOwnDialogue() {
        codes.accept(REGISTERED);
        isBusy = true;
        result();
        isBusy = false;
        codes.accept(ANSWER);
        expectSent(RESULT);
    }
}
