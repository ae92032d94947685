/**
 * State machines as tables. Read {@link simgsm.state.StateTable}.
 */
package simgsm.state;
