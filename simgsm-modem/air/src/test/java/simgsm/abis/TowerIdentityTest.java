package simgsm.abis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TowerIdentityTest {
    @Test
    void aTowerTellsItsCellInTheUnitName() {
        TowerIdentity west = new TowerIdentity("6969/0/0", "west", 512, 20, 7, 4711, 3, 8, 5, 6);

        assertEquals(
                "west arfcn=512 bsic=20 lac=7 cell=4711 tch=3 timeout=8 access=5 hysteresis=6",
                west.response().unitName());
        assertEquals(west, TowerIdentity.of(west.response(), 5));
    }

    @Test
    void whatATowerDoesNotTellFollowsFromItsPlaceAmongTheTowers() {
        assertEquals(
                new TowerIdentity("6969/0/0", "6969", 100, 10, 1, 6969, 7, 32, 0, 4),
                TowerIdentity.of(new CcmMessage.IdentityResponse("", "", "6969/0/0"), 0));
        assertEquals(
                new TowerIdentity("6970/0/0", "bts", 110, 11, 2, 6970, 7, 32, 0, 4),
                TowerIdentity.of(new CcmMessage.IdentityResponse("bts lac=2", "", "6970/0/0"), 1));
    }

    @ParameterizedTest
    @CsvSource({
        "6969, ''",
        "a/0/0, ''",
        "1/0/0, x arfcn=1024",
        "1/0/0, x bsic=64",
        "1/0/0, x tch=0",
        "1/0/0, x timeout=2",
        "1/0/0, x access=64",
        "1/0/0, x hysteresis=16"
    })
    void aTowerThatCannotBeIsRefused(String unitId, String unitName) {
        CcmMessage.IdentityResponse response = new CcmMessage.IdentityResponse(unitName, "", unitId);

        assertThrows(IllegalArgumentException.class, () -> TowerIdentity.of(response, 0));
    }
}
