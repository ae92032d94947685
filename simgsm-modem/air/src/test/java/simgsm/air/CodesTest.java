package simgsm.air;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.ToIntFunction;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.abis.RslMessage;
import simgsm.ss.SsError;

class CodesTest {
    @Test
    void codesAreDistinct() {
        assertDistinct(Cause.values(), Cause::code);
        assertDistinct(RejectCause.values(), RejectCause::code);
        assertDistinct(RpCause.values(), RpCause::code);
        assertDistinct(MobileIdentity.Type.values(), MobileIdentity.Type::code);
        assertDistinct(MobilityManagement.ServiceType.values(), MobilityManagement.ServiceType::code);
        assertDistinct(RslMessage.Sapi.values(), RslMessage.Sapi::code);
        assertDistinct(Layer3Type.values(), type -> type.discriminator() << 8 | type.code());
    }

    @Test
    void everyCauseHasATitleInSpanish() {
        Stream.<Coded.Titled[]>of(Cause.values(), RejectCause.values(), RpCause.values(), SsError.values())
                .flatMap(Arrays::stream)
                .forEach(cause -> assertNotEquals(cause.title(), cause.title(Locale.forLanguageTag("es"))));
        assertEquals("usuario ocupado", Cause.USER_BUSY.title(Locale.forLanguageTag("es-PE")));
        assertEquals("user busy", Cause.USER_BUSY.title(Locale.GERMAN));
    }

    @ParameterizedTest
    @EnumSource
    void causesComeBack(Cause cause) {
        assertSame(cause, Cause.ofCode(cause.code()));
    }

    @ParameterizedTest
    @EnumSource
    void rejectCausesComeBack(RejectCause cause) {
        assertSame(cause, RejectCause.ofCode(cause.code(), Direction.UPLINK));
        assertSame(cause, RejectCause.ofCode(cause.code(), Direction.DOWNLINK));
    }

    @ParameterizedTest
    @EnumSource
    void relayCausesComeBack(RpCause cause) {
        assertSame(cause, RpCause.ofCode(cause.code()));
    }

    @ParameterizedTest
    @EnumSource
    void identityTypesComeBack(MobileIdentity.Type type) {
        assertSame(type, Coded.find(MobileIdentity.Type.values(), type.code()).orElseThrow());
    }

    @ParameterizedTest
    @EnumSource
    void messageTypesComeBackTheWayThatTheyGo(Layer3Type type) {
        for (Direction direction : Direction.values()) {
            assertEquals(
                    type.goes(direction),
                    Layer3Type.of(type.discriminator(), type.code(), direction).isPresent());
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 31", "2, 31", "33, 47", "48, 63", "64, 79", "80, 95", "103, 111", "112, 127", "126, 127"})
    void anUnlistedCauseIsTheUnspecifiedOneOfItsClass(int code, int expected) {
        assertEquals(expected, Cause.ofCode(code).code());
    }

    @ParameterizedTest
    @CsvSource({"0", "5", "8"})
    void anUnassignedIdentityTypeIsRefused(int code) {
        byte[] identityRequest = {5, 0x18, (byte) code};
        assertThrows(ProtocolViolation.class, () -> Layer3Codec.decode(identityRequest, Direction.DOWNLINK));
    }

    private static <T> void assertDistinct(T[] values, ToIntFunction<T> code) {
        assertEquals(
                values.length, Arrays.stream(values).mapToInt(code).distinct().count());
    }
}
