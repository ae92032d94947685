/**
 * The demo: starts centre, phone and SimRobot as processes and plays a session. Read {@link simgsm.center.demo.HeadlessDemo}.
 */
package simgsm.center.demo;
